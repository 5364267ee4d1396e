#include "replay/output/frame_name.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(FrameName, TakesTheNumberOnce) {
  EXPECT_EQ(*frame_name("a-%04d.png", 7), "a-0007.png");
  EXPECT_EQ(*frame_name("a-%d.png", 12), "a-12.png");
  EXPECT_EQ(*frame_name("a-%3d.png", 7), "a-  7.png");  // as printf has it
  EXPECT_EQ(*frame_name("%02d/x.exr", 123), "123/x.exr");
  EXPECT_FALSE(frame_name("a.png", 1));
  EXPECT_FALSE(frame_name("a-%.png", 1));
  EXPECT_FALSE(frame_name("%d-%d.png", 1));
}

}  // namespace
}  // namespace pentimento

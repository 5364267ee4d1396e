#include "core/base/interruption.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(Interruption, IsHeardOnceItsFlagIsSet) {
  std::atomic<bool> cancelled{false};
  EXPECT_TRUE(unless_interrupted(&cancelled).ok());
  EXPECT_TRUE(unless_interrupted(nullptr).ok());
  cancelled = true;
  const Result<void> heard = unless_interrupted(&cancelled);
  ASSERT_FALSE(heard.ok());
  EXPECT_EQ(heard.error().code, ErrorCode::kInterrupted);
}

}  // namespace
}  // namespace pentimento

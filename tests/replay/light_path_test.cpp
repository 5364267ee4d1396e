#include "replay/light_path.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(LightPath, AnOrbitGoesOnceAroundAndKeepsItsHeight) {
  Lamp lamp;
  lamp.direction = {0.6f, 0, 0.8f};
  const auto path = light_path("orbit", 4, lamp);
  ASSERT_TRUE(path);
  ASSERT_EQ(path->size(), 4u);
  EXPECT_EQ((*path)[0], lamp.direction);
  EXPECT_NEAR((*path)[1][1], 0.6f, 1e-6f);   // a quarter turn: straight above
  EXPECT_NEAR((*path)[2][0], -0.6f, 1e-6f);  // float rounding
  for (const auto& place : *path) EXPECT_EQ(place[2], 0.8f);
}

TEST(LightPath, AFileIsFollowedFromItsFirstPointToItsLast) {
  const test::Scratch scratch;
  test::spill(scratch.path("p"), "# from the left to the right\n-1 0 1\n\n1, 0, 1\n");
  const auto path = light_path(scratch.path("p"), 3, Lamp{});
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_NEAR((*path)[0][0], -0.70711f, 1e-5f);
  EXPECT_EQ((*path)[1], (std::array<float, 3>{0, 0, 1}));
  EXPECT_NEAR((*path)[2][0], 0.70711f, 1e-5f);
}

TEST(LightPath, ABrokenLineIsNamed) {
  const test::Scratch scratch;
  test::spill(scratch.path("p"), "1 0 1\n1 0\n");
  const auto path = light_path(scratch.path("p"), 3, Lamp{});
  ASSERT_FALSE(path);
  EXPECT_NE(path.error().message.find(":2: "), std::string::npos);
  EXPECT_FALSE(light_path(scratch.path("none"), 3, Lamp{}));
  EXPECT_FALSE(light_path("orbit", 0, Lamp{}));
}

TEST(FrameName, TakesTheNumberOnce) {
  EXPECT_EQ(*frame_name("a-%04d.png", 7), "a-0007.png");
  EXPECT_EQ(*frame_name("a-%d.png", 12), "a-12.png");
  EXPECT_FALSE(frame_name("a.png", 1));
  EXPECT_FALSE(frame_name("a-%.png", 1));
  EXPECT_FALSE(frame_name("%d-%d.png", 1));
}

}  // namespace
}  // namespace pentimento

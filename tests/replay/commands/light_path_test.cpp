#include "replay/commands/light_path.h"

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

TEST(LightPath, AnOrbitTurnsALampThatStandsAnywhere) {
  Lamp lamp;
  lamp.direction = {0.48f, 0.64f, 0.6f};
  const auto path = light_path("orbit", 4, lamp);
  ASSERT_TRUE(path);
  const std::array<float, 3> quarter = {-0.64f, 0.48f, 0.6f};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR((*path)[1][i], quarter[i], 1e-6f) << i;
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

TEST(LightPath, ANearLampGoesWhereTheFileSaysAFarOneOnlyThatWay) {
  const test::Scratch scratch;
  test::spill(scratch.path("p"), "0 0 2\n0.5 0.25 4\n");
  Lamp near;
  near.position_m = {1, 1, 1};
  const auto path = light_path(scratch.path("p"), 3, near);
  ASSERT_TRUE(path) << path.error().message;
  EXPECT_EQ((*path)[0], (std::array<float, 3>{0, 0, 2}));
  EXPECT_EQ((*path)[1], (std::array<float, 3>{0.25f, 0.125f, 3}));
  EXPECT_EQ((*path)[2], (std::array<float, 3>{0.5f, 0.25f, 4}));
  EXPECT_EQ((*light_path("orbit", 2, near))[1][2], 1);
  EXPECT_NEAR((*light_path("orbit", 2, near))[1][0], -1, 1e-6);  // float rounding
  EXPECT_EQ((*light_path(scratch.path("p"), 1, Lamp{}))[0], (std::array<float, 3>{0, 0, 1}));
}

TEST(LightPath, PointsThatAreNoPlaceAreRefused) {
  const test::Scratch scratch;
  for (const char* wrong : {"", "# nothing\n", "0 0 0\n", "1 2 3 4\n", "1 2 x\n"}) {
    test::spill(scratch.path("p"), wrong);
    EXPECT_FALSE(light_path(scratch.path("p"), 2, Lamp{})) << wrong;
  }
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

}  // namespace
}  // namespace pentimento

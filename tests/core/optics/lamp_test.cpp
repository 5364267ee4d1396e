#include "core/optics/lamp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento {
namespace {

constexpr float kRounding = 1e-6f;
void expect_direction(std::array<float, 3> d, std::array<float, 3> expected) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(d[i], expected[i], kRounding) << i;
}
Lamp following(std::array<float, 3> direction) {
  Lamp lamp;
  lamp.direction = direction;
  lamp.follows_gravity = true;
  return lamp;
}

TEST(LampDirection, StaysPutUnlessItFollows) {
  const Lamp lamp;
  EXPECT_EQ(lamp_direction(lamp, {0, 9.81f, 0}), lamp.direction);
}

TEST(LampDirection, LyingFlatIsTheLampsOwn) {
  expect_direction(lamp_direction(following({-.48f, .6f, .64f}), {0, 0, 9.81f}),
                   {-.48f, .6f, .64f});
}

TEST(LampDirection, OfALampStraightAboveIsTheNormalisedGravity) {
  expect_direction(lamp_direction(following({0, 0, 1}), {0, 6, 8}), {0, .6f, .8f});
  expect_direction(lamp_direction(following({0, 0, 1}), {9.81f, 0, 0}), {1, 0, 0});
}

TEST(LampPosition, TurnsAboutTheCentreAsTheDirectionDoes) {
  Lamp lamp = following({0, 0, 1});
  lamp.position_m = {0, 0, 2};
  expect_direction(lamp_position(lamp, {0, 6, 8}), {0, 1.2f, 1.6f});
  lamp.follows_gravity = false;
  expect_direction(lamp_position(lamp, {0, 6, 8}), {0, 0, 2});
}

TEST(LampDirection, ALampOnTheFarSideGoesBehindTheTabletHeldUpright) {
  expect_direction(lamp_direction(following({0, 1, 0}), {0, 9.81f, 0}), {0, 0, -1});
  expect_direction(lamp_direction(following({1, 0, 0}), {0, 9.81f, 0}), {1, 0, 0});
}

TEST(LampDirection, KeepsItsAngleToTheVerticalAndItsLength) {
  const Lamp lamp = following({-.48f, .6f, .64f});
  for (int i = 0; i < 40; ++i) {
    const float t = 0.37f * static_cast<float>(i);
    const std::array<float, 3> g = {9 * std::sin(t), 9 * std::cos(2 * t), 4 * std::cos(3 * t)};
    const float length = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    const auto l = lamp_direction(lamp, g);
    EXPECT_NEAR(l[0] * l[0] + l[1] * l[1] + l[2] * l[2], 1, 5 * kRounding);
    EXPECT_NEAR((l[0] * g[0] + l[1] * g[1] + l[2] * g[2]) / length, .64f, 5 * kRounding);
  }
}

TEST(LampDirection, FaceDownIsHalfATurnAndFreeFallNone) {
  const Lamp lamp = following({-.48f, .6f, .64f});
  expect_direction(lamp_direction(lamp, {0, 0, -9.81f}), {-.48f, -.6f, -.64f});
  EXPECT_EQ(lamp_direction(lamp, {0, 0.01f, 0}), lamp.direction);
}

}  // namespace
}  // namespace pentimento

#include "formats/import/sketch/pen_angles.h"

#include <gtest/gtest.h>

namespace pentimento::sketch {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

void expect_tilts(double altitude_deg, double azimuth_deg, float tilt_x, float tilt_y) {
  const auto [x, y] = tilts_deg(altitude_deg * kDegree, azimuth_deg * kDegree);
  EXPECT_NEAR(x, tilt_x, 1e-4f) << altitude_deg << " " << azimuth_deg;
  EXPECT_NEAR(y, tilt_y, 1e-4f) << altitude_deg << " " << azimuth_deg;
}

// The cases of the specification's table, and the ends of the range.
TEST(PenAngles, AreTheTiltsOfTheSpecification) {
  expect_tilts(90, 0, 0, 0);
  expect_tilts(90, 123, 0, 0);
  expect_tilts(45, 0, 45, 0);
  expect_tilts(45, 90, 0, 45);
  expect_tilts(45, 180, -45, 0);
  expect_tilts(45, 270, 0, -45);
  expect_tilts(60, 0, 30, 0);
  expect_tilts(45, 45, 35.26439f, 35.26439f);
  expect_tilts(0, 0, 90, 0);
  expect_tilts(-10, 0, 90, 0);
  expect_tilts(120, 0, 0, 0);
}

}  // namespace
}  // namespace pentimento::sketch

#include "replay/compare/flip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "replay/compare/flip_color.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using Planes = std::vector<Field<float>>;

Planes constant(int width, int height, float r, float g, float b) {
  Planes planes;
  for (const float v : {r, g, b}) planes.emplace_back(width, height, v);
  return planes;
}

RgbPlanes views(const Planes& planes) {
  return {planes[0].view(), planes[1].view(), planes[2].view()};
}

Field<float> flip(const Planes& a, const Planes& b, int threads = 1) {
  return flip_map(views(a), views(b), kFlipPixelsPerDegree, Threads(threads));
}

double mean(const Field<float>& map) {
  double sum = 0;
  for (int y = 0; y < map.height(); ++y)
    for (int x = 0; x < map.width(); ++x) sum += static_cast<double>(map(x, y));
  return sum / (map.width() * map.height());
}

TEST(Flip, EqualPicturesDifferNowhere) {
  const auto planes = test::made_up_planes(50, 40, 3);
  const Field<float> map = flip(planes, planes);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 50; ++x) ASSERT_EQ(map(x, y), 0.0f);
}

TEST(Flip, IsSymmetric) {
  const auto a = test::made_up_planes(50, 40, 3);
  const auto b = test::made_up_planes(50, 40, 5);
  Planes other;
  for (std::size_t c = 2; c < 5; ++c) other.push_back(b[c].clone());
  const Field<float> ab = flip(a, other), ba = flip(other, a);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 50; ++x) ASSERT_EQ(ab(x, y), ba(x, y));
}

TEST(Flip, GreenAgainstBlueIsTheLargestColourDifference) {
  // The metric is scaled so that these two primaries differ by 1. Filtering and clamping constant
  // pictures leaves single-precision noise.
  const Field<float> map = flip(constant(30, 20, 0, 1, 0), constant(30, 20, 0, 0, 1));
  EXPECT_NEAR(static_cast<double>(map(15, 10)), 1.0, 1e-4);
}

TEST(Flip, BlackAgainstWhiteFollowsFromItsLightness) {
  // A difference of L = 100 alone: 100^0.7 beyond the knee at 0.4 of the largest, by hand.
  const double largest =
      std::pow(flip::hyab(flip::hunt_lab_of_rgb({0, 1, 0}), flip::hunt_lab_of_rgb({0, 0, 1})), 0.7);
  const double knee = 0.4 * largest;
  const double expected = 0.95 + (std::pow(100.0, 0.7) - knee) / (largest - knee) * 0.05;
  EXPECT_GT(expected, 0.95);
  const Field<float> map = flip(constant(30, 20, 0, 0, 0), constant(30, 20, 1, 1, 1));
  EXPECT_NEAR(static_cast<double>(map(3, 4)), expected, 1e-4);
}

TEST(Flip, GrowsWithTheDifference) {
  double before = 0;
  for (const float v : {0.51f, 0.55f, 0.6f, 0.8f, 1.0f}) {
    const double now = mean(flip(constant(9, 9, 0.5f, 0.5f, 0.5f), constant(9, 9, v, v, v)));
    EXPECT_GT(now, before) << v;
    before = now;
  }
}

TEST(Flip, DoesNotDependOnThreads) {
  const auto a = test::made_up_planes(50, 40, 3);
  const Planes b = constant(50, 40, 0.2f, 0.4f, 0.6f);
  const Field<float> one = flip(a, b, 1), seven = flip(a, b, 7);
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 50; ++x) ASSERT_EQ(one(x, y), seven(x, y));
}

TEST(FlipColor, WhiteIsTheOriginOfColour) {
  const flip::ColorTriple ycc = flip::ycxcz_of_rgb({1, 1, 1});
  EXPECT_NEAR(ycc[0], 100, 1e-12);
  EXPECT_NEAR(ycc[1], 0, 1e-12);
  EXPECT_NEAR(ycc[2], 0, 1e-12);
}

TEST(FlipColor, OpponentSpaceGoesBack) {
  const flip::ColorTriple rgb = flip::rgb_of_ycxcz(flip::ycxcz_of_rgb({0.2, 0.7, 0.05}));
  EXPECT_NEAR(rgb[0], 0.2, 1e-12);
  EXPECT_NEAR(rgb[1], 0.7, 1e-12);
  EXPECT_NEAR(rgb[2], 0.05, 1e-12);
}

TEST(FlipColor, LabOfTheRedPrimaryIsTheKnownOne) {
  // CIELAB of sRGB red under D65: L 53.24, a 80.09, b 67.20 (Lindbloom), before Hunt's 0.01 L.
  const flip::ColorTriple lab = flip::hunt_lab_of_rgb({1, 0, 0});
  EXPECT_NEAR(lab[0], 53.24, 0.01);
  EXPECT_NEAR(lab[1], 0.5324 * 80.09, 0.02);
  EXPECT_NEAR(lab[2], 0.5324 * 67.20, 0.02);
}

}  // namespace
}  // namespace pentimento

#include "formats/image/resample.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace pentimento {
namespace {

Field<float> row_of(std::initializer_list<float> values) {
  Field<float> f(static_cast<int>(values.size()), 1);
  int x = 0;
  for (const float v : values) f(x++, 0) = v;
  return f;
}

/// A polynomial of x over the unit interval, at pixel centres.
Field<float> sampled(int n, double (*f)(double)) {
  Field<float> out(n, 1);
  for (int x = 0; x < n; ++x) out(x, 0) = static_cast<float>(f((x + 0.5) / n));
  return out;
}

double sum(const Field<float>& f) {
  double s = 0;
  for (int y = 0; y < f.height(); ++y)
    for (int x = 0; x < f.width(); ++x) s += static_cast<double>(f(x, y));
  return s;
}

TEST(ResampleArea, IsTheMeanOverEachPixel) {
  const Field<float> half = resample_area(row_of({1, 3, 5, 7}).view(), 2, 1);
  EXPECT_EQ(half(0, 0), 2);
  EXPECT_EQ(half(1, 0), 6);
  // Three pixels onto two: [1, 3 | 3, 5] with the middle one split.
  const Field<float> split = resample_area(row_of({1, 3, 5}).view(), 2, 1);
  EXPECT_FLOAT_EQ(split(0, 0), (1 + 0.5f * 3) / 1.5f);
  EXPECT_FLOAT_EQ(split(1, 0), (0.5f * 3 + 5) / 1.5f);
}

TEST(ResampleArea, KeepsTheMeanAtAnyRatio) {
  Field<float> f(37, 23);
  for (int y = 0; y < 23; ++y)
    for (int x = 0; x < 37; ++x) f(x, y) = static_cast<float>((x * 7 + y * 13) % 11);
  for (const auto& [w, h] : {std::pair{36, 22}, {5, 3}, {1, 1}, {74, 46}, {50, 40}}) {
    const Field<float> g = resample_area(f.view(), w, h);
    // Single-precision weights: a relative 1e-6.
    EXPECT_NEAR(sum(g) / (w * h), sum(f) / (37 * 23), 1e-5) << w << " x " << h;
  }
}

TEST(ResampleBilinear, IsExactForAStraightLineInside) {
  const auto line = [](double x) { return 2 * x - 0.5; };
  const Field<float> g = resample_bilinear(sampled(8, line).view(), 21, 1);
  for (int x = 2; x < 19; ++x)  // beyond the outer centres the edge continues
    EXPECT_NEAR(static_cast<double>(g(x, 0)), line((x + 0.5) / 21), 1e-6);
}

TEST(ResampleBicubic, IsExactForAParabolaInside) {
  const auto parabola = [](double x) { return 3 * x * x - x + 0.25; };
  const Field<float> g = resample_bicubic(sampled(16, parabola).view(), 41, 1);
  for (int x = 5; x < 36; ++x)  // four taps away from the edge
    EXPECT_NEAR(static_cast<double>(g(x, 0)), parabola((x + 0.5) / 41), 2e-6);
}

TEST(ResampleBicubic, ConvergesWithOrderThree) {
  const auto wave = [](double x) { return std::sin(6.0 * x); };
  double error[2];
  for (int k = 0; k < 2; ++k) {
    const int n = k == 0 ? 32 : 64;
    const Field<float> g = resample_bicubic(sampled(n, wave).view(), 301, 1);
    error[k] = 0;
    for (int x = 60; x < 240; ++x)
      error[k] = std::max(error[k], std::abs(static_cast<double>(g(x, 0)) - wave((x + 0.5) / 301)));
  }
  EXPECT_GT(std::log2(error[0] / error[1]), 2.8);
}

TEST(ResampleTo, ShrinksByAreaAndGrowsBilinearly) {
  Field<float> f(4, 2);
  f(0, 0) = 4;
  const Field<float> g = resample_to(f.view(), 2, 4);
  const Field<float> narrow = resample_area(f.view(), 2, 2);
  const Field<float> expected = resample_bilinear(narrow.view(), 2, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 2; ++x) EXPECT_FLOAT_EQ(g(x, y), expected(x, y));
}

TEST(SampleTiled, RepeatsATileExactly) {
  Field<float> tile(3, 2);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x) tile(x, y) = static_cast<float>(1 + x + 3 * y);
  const Field<float> g = sample_repeated(tile.view(), 8, 5, 3, 2);
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 8; ++x) EXPECT_EQ(g(x, y), tile(x % 3, y % 2));
}

TEST(SampleTiled, HasNoSeam) {
  // A tile of one wave, magnified to 40 cells: steps across the seam are as small as elsewhere.
  Field<float> tile(16, 1);
  for (int x = 0; x < 16; ++x)
    tile(x, 0) = std::sin(6.2831853f * (static_cast<float>(x) + 0.5f) / 16);
  const Field<float> g = sample_repeated(tile.view(), 120, 1, 40, 1);
  for (int x = 1; x < 120; ++x) {
    // Steepest slope 2 pi / 40 per cell.
    EXPECT_LT(std::abs(g(x, 0) - g(x - 1, 0)), 0.16f) << x;
    if (x >= 40) {
      EXPECT_NEAR(g(x, 0), g(x - 40, 0), 1e-6f);
    }
  }
}

TEST(SampleTiled, AveragesATileThatIsReduced) {
  // Two and a half texels to a cell: every cell is a mean, and the mean of all is the tile's.
  Field<float> tile(10, 10);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 10; ++x) tile(x, y) = static_cast<float>((x + y) % 2);
  const Field<float> g = sample_repeated(tile.view(), 8, 8, 4, 4);
  EXPECT_NEAR(sum(g) / 64, 0.5, 1e-6);
  for (int x = 0; x < 8; ++x) EXPECT_NEAR(g(x, 3), 0.5f, 0.5f * 0.2f * 0.2f + 1e-6f);
}

TEST(Resample, IsFrozen) {
  // What reaches the state must never change: an FNV-1a of the bits, computed once.
  Field<float> f(17, 13);
  for (int y = 0; y < 13; ++y)
    for (int x = 0; x < 17; ++x) f(x, y) = static_cast<float>((x * x + 3 * y) % 29) / 29.0f;
  const auto hash = [](const Field<float>& g) {
    std::uint64_t h = 14695981039346656037u;
    for (int y = 0; y < g.height(); ++y)
      for (int x = 0; x < g.width(); ++x)
        h = (h ^ std::bit_cast<std::uint32_t>(g(x, y))) * 1099511628211u;
    return h;
  };
  EXPECT_EQ(hash(resample_area(f.view(), 7, 5)), 16342899540472185923u);
  EXPECT_EQ(hash(resample_bilinear(f.view(), 40, 31)), 1391679633993064148u);
  EXPECT_EQ(hash(resample_bicubic(f.view(), 40, 31)), 300458561343144644u);
  EXPECT_EQ(hash(sample_repeated(f.view(), 40, 31, 23.7, 9.3)), 5223548488118324771u);
}

}  // namespace
}  // namespace pentimento

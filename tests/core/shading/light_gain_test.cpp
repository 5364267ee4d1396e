#include "core/shading/light_gain.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento {
namespace {

/// Whole and other factors, single cells, as many pixels as cells.
const std::vector<GainAxis> kAxes = {{5, 20}, {10, 25}, {7, 7},   {3, 10},    {1, 9},
                                     {1, 1},  {8, 9},   {29, 84}, {480, 1391}};

TEST(GainAxis, EveryPixelIsInExactlyOneCell) {
  for (const GainAxis& axis : kAxes) {
    EXPECT_EQ(axis.first_pixel(0), 0);
    EXPECT_EQ(axis.first_pixel(axis.cells), axis.pixels);
    for (int cell = 0; cell < axis.cells; ++cell) {
      const int begin = axis.first_pixel(cell), end = axis.first_pixel(cell + 1);
      EXPECT_LT(begin, end) << "cell " << cell << " of " << axis.cells;  // none is empty
      for (int p = begin; p < end; ++p) EXPECT_EQ(axis.cell_of(p), cell) << "pixel " << p;
    }
  }
}

TEST(GainAxis, APixelBelongsWhereItsCentreLies) {
  // Ten cells on 25 pixels: the centre of pixel 2 is the border at 2.5, and of the cell after it.
  const GainAxis axis{10, 25};
  const std::vector<int> expected = {0, 0, 1, 1, 1, 2, 2, 3, 3, 3};
  for (int p = 0; p < 10; ++p) EXPECT_EQ(axis.cell_of(p), expected[static_cast<std::size_t>(p)]);
  EXPECT_EQ(axis.first_pixel(1), 2);
  EXPECT_EQ(axis.first_pixel(2), 5);
}

TEST(GainAxis, HoldsTheLargestPictures) {
  const GainAxis axis{60000, 1900000};  // their product is beyond 32 bits
  EXPECT_EQ(axis.cell_of(1899999), 59999);
  EXPECT_EQ(axis.first_pixel(60000), 1900000);
}

TEST(GainLine, WeightsByHand) {
  // Four pixels a cell: centres at 1/8, 3/8, 5/8, 7/8. (1 - t)^2 / 2, the rest, t^2 / 2.
  const GainLine line({3, 12}, {0, 3});
  ASSERT_EQ(line.weight.size(), 12u);
  EXPECT_EQ(line.begin, (std::vector<int>{0, 4, 8, 12}));
  EXPECT_EQ(line.weight[4], (std::array<float, 3>{49 / 128.0f, 78 / 128.0f, 1 / 128.0f}));
  EXPECT_EQ(line.weight[6], (std::array<float, 3>{9 / 128.0f, 94 / 128.0f, 25 / 128.0f}));
}

TEST(GainLine, SharesAreNoneNegativeAndMakeOne) {
  for (const GainAxis& axis : kAxes) {
    for (const auto& [before, own, after] : GainLine(axis, {0, axis.cells}).weight) {
      EXPECT_GE(before, 0);
      EXPECT_GE(own, 0.5f);
      EXPECT_GE(after, 0);
      EXPECT_NEAR(before + own + after, 1, 2e-7f);  // three roundings of float
    }
  }
}

TEST(GainLine, ARunIsAPartOfTheWhole) {
  for (const GainAxis& axis : kAxes) {
    const GainLine whole(axis, {0, axis.cells});
    EXPECT_EQ(whole.cells(), axis.cells);
    EXPECT_EQ(whole.pixel_run.count, axis.pixels);
    const int first = axis.cells / 3, count = (axis.cells + 2) / 3;
    const GainLine part(axis, {first, count});
    ASSERT_EQ(part.cells(), count);
    EXPECT_EQ(part.pixel_run.first, axis.first_pixel(first));
    EXPECT_EQ(part.begin.front(), 0);
    EXPECT_EQ(part.begin.back(), part.pixel_run.count);
    ASSERT_EQ(part.weight.size(), static_cast<std::size_t>(part.pixel_run.count));
    for (int c = 0; c <= count; ++c)
      EXPECT_EQ(part.begin[static_cast<std::size_t>(c)] + part.pixel_run.first,
                axis.first_pixel(first + c));
    for (std::size_t p = 0; p < part.weight.size(); ++p)
      EXPECT_EQ(part.weight[p], whole.weight[p + static_cast<std::size_t>(part.pixel_run.first)]);
  }
}

/// The factors on a row of pixels; `rows` are the gains above, of the row and below.
std::vector<float> factors(const GainLine& across, const std::array<float, 3>& down,
                           const std::array<std::vector<float>, 3>& rows) {
  std::vector<float> out(static_cast<std::size_t>(across.pixel_run.count), -1.0f);
  for (int i = 0; i < across.cells(); ++i)
    gain_pixels(across, i, down, {rows[0].data(), rows[1].data(), rows[2].data()},
                &out[static_cast<std::size_t>(across.begin[static_cast<std::size_t>(i)])]);
  return out;
}

/// The same gains in all three rows.
std::vector<float> factors(const GainLine& across, const std::vector<float>& gain) {
  return factors(across, {0.25f, 0.5f, 0.25f}, {gain, gain, gain});
}

TEST(GainPixels, AConstantGainIsThatConstant) {
  for (const GainAxis& axis : kAxes) {
    const GainLine line(axis, {0, axis.cells});
    for (const float f :
         factors(line, std::vector<float>(static_cast<std::size_t>(axis.cells), 1.7f)))
      EXPECT_NEAR(f, 1.7f, 1e-6f);  // a few roundings of float
  }
}

TEST(GainPixels, ASlopeIsThatSlope) {
  // Quadratic B-splines keep straight lines. The gain of a cell is its centre's place.
  for (const GainAxis& axis : {GainAxis{6, 24}, GainAxis{10, 25}, GainAxis{9, 9}}) {
    std::vector<float> place;
    for (int i = 0; i < axis.cells; ++i) place.push_back(static_cast<float>(i) + 0.5f);
    const std::vector<float> f = factors(GainLine(axis, {0, axis.cells}), place);
    for (int p = axis.first_pixel(1); p < axis.first_pixel(axis.cells - 1); ++p) {
      const float x = (static_cast<float>(p) + 0.5f) * static_cast<float>(axis.cells) /
                      static_cast<float>(axis.pixels);
      EXPECT_NEAR(f[static_cast<std::size_t>(p)], x, 1e-5f) << p;  // roundings of floats up to 10
    }
  }
}

TEST(GainPixels, RowsAreWeighedFromTheTop) {
  const GainLine line({2, 2}, {0, 2});
  const std::vector<float> f =
      factors(line, {0.125f, 0.75f, 0.5f}, {std::vector<float>{8, 8}, {16, 16}, {32, 32}});
  EXPECT_EQ(f, (std::vector<float>{29, 29}));  // 1 + 12 + 16
}

TEST(GainPixels, EdgesRepeatTheOutermostCell) {
  // Across the outer half of an edge cell the spline sees its own gain beyond the edge: 4 pixels a
  // cell, at 1/8 of the first: 49/128 + 78/128 of 1, 1/128 of 3.
  const std::vector<float> f = factors(GainLine({2, 8}, {0, 2}), {1, 3});
  EXPECT_FLOAT_EQ(f[0], (49 + 78 + 3) / 128.0f);
  EXPECT_FLOAT_EQ(f[7], (1 + 3 * 78 + 3 * 49) / 128.0f);
}

TEST(GainPixels, IsContinuousWithItsSlope) {
  constexpr int kPixels = 200;  // a cell
  const std::vector<float> gain = {1, 4, 0.25f, 2, 2, 0.125f};
  const std::vector<float> f = factors(GainLine({6, 6 * kPixels}, {0, 6}), gain);
  // In a cell: slopes of at most 3.75 a cell, the largest step; they change by at most 7.5 a cell,
  // the sum of two such steps. A jump at a border would be of the order of the gains.
  float steepest = 0, bent = 0;
  for (std::size_t p = 2; p < f.size(); ++p) {
    steepest = std::max(steepest, std::abs(f[p] - f[p - 1]));
    bent = std::max(bent, std::abs(f[p] - 2 * f[p - 1] + f[p - 2]));
  }
  EXPECT_LT(steepest, 3.75f / kPixels + 1e-6f);  // roundings
  EXPECT_LT(bent, 7.5f / kPixels / kPixels + 2e-6f);
  // At a border: the mean of the two, but for half a pixel's slope.
  EXPECT_NEAR(f[kPixels], 2.5f, 0.5f * 3 / kPixels + 1e-6f);
  EXPECT_NEAR(f[kPixels - 1], 2.5f, 0.5f * 3 / kPixels + 1e-6f);
}

TEST(GainPixels, StaysWithinTheGains) {
  const std::vector<float> gain = {0.125f, 4, 0.125f, 4, 4, 0.125f};
  for (const float f : factors(GainLine({6, 17}, {0, 6}), gain)) {
    EXPECT_GE(f, 0.125f * (1 - 1e-6f));
    EXPECT_LE(f, 4 * (1 + 1e-6f));
  }
}

/// Whole cells, some of the run only, cells of unequal size, one pixel a cell, one cell.
TEST(GainMoments, SumWhatGainPixelsMultiplies) {
  struct Part {
    GainAxis axis;
    int first, last;
  };
  for (const Part& part :
       {Part{{5, 40}, 0, 5}, {{5, 40}, 1, 3}, {{10, 25}, 3, 8}, {{7, 7}, 2, 7}, {{1, 9}, 0, 1}}) {
    const GainLine across(part.axis, {0, part.axis.cells});
    const auto width = static_cast<std::size_t>(part.axis.pixels);
    const auto cells = static_cast<std::size_t>(part.axis.cells);
    const std::vector<std::array<float, 3>> down = {{0.5f, 0.5f, 0}, {0.1f, 0.7f, 0.2f}};
    std::vector<std::vector<float>> light(2, std::vector<float>(width)), gain(3);
    for (std::size_t p = 0; p < 2; ++p)
      for (std::size_t x = 0; x < width; ++x)
        light[p][x] = 0.1f + 0.3f * static_cast<float>((7 * x + 5 * p) % 11);
    for (std::size_t n = 0; n < 3; ++n)
      for (std::size_t i = 0; i < cells; ++i)
        gain[n].push_back(0.5f + 0.25f * static_cast<float>((3 * i + 2 * n) % 7));
    const GainRows rows = {gain[0].data(), gain[1].data(), gain[2].data()};
    std::vector<float> moment(kGainMoments * cells, 0), sum(cells), factor(width);
    const std::array<const float*, 2> pixels = {light[0].data(), light[1].data()};
    find_gain_moments(across, part.first, part.last, pixels, down.data(), moment.data());
    sum_under_gain(moment.data(), part.axis.cells, rows, sum.data());
    for (int i = 0; i < part.axis.cells; ++i) {
      double expected = 0;
      for (std::size_t p = 0; p < 2 && i >= part.first && i < part.last; ++p) {
        gain_pixels(across, i, down[p], rows, factor.data());
        const int begin = across.begin[static_cast<std::size_t>(i)];
        for (int x = begin; x < across.begin[static_cast<std::size_t>(i) + 1]; ++x)
          expected += static_cast<double>(light[p][static_cast<std::size_t>(x)]) *
                      static_cast<double>(factor[static_cast<std::size_t>(x - begin)]);
      }
      // Some thirty roundings of float.
      EXPECT_NEAR(sum[static_cast<std::size_t>(i)], expected, 2e-6 * expected) << i;
    }
  }
}

TEST(LightRatio, IsLimitedAndTellsNoBlacksApart) {
  EXPECT_EQ(light_ratio(0, 0), 1);
  EXPECT_EQ(light_ratio(0.3f, 0.3f), 1);
  EXPECT_EQ(light_ratio(0, 1), 0.5f);
  EXPECT_EQ(light_ratio(1, 0), 2);
  EXPECT_EQ(light_ratio(1e30f, 0), 2);
  // 0.45 / 0.4, with 0.002 added to both.
  EXPECT_FLOAT_EQ(light_ratio(0.45f, 0.4f), 0.452f / 0.402f);
  EXPECT_FLOAT_EQ(light_ratio(0.001f, 0), 1.5f);
}

}  // namespace
}  // namespace pentimento

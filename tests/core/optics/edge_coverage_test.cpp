#include "core/optics/edge_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace pentimento {
namespace {

constexpr int kCanvasSide = 12;
using Depth = std::function<double(int x, int y)>;  // m, mean of a cell

/// The coverage of row y of a grid without end.
std::vector<float> coverage_of(const Depth& depth, int y, int width = kCanvasSide) {
  CoverageRows rows;
  for (int n = -kCoverageReach; n <= kCoverageReach; ++n)
    for (int x = -kCoverageReach; x < width + kCoverageReach; ++x)
      rows[static_cast<std::size_t>(n + kCoverageReach)].push_back(
          static_cast<float>(depth(x, y + n)));
  std::vector<float> coverage(static_cast<std::size_t>(width));
  edge_coverage_row(rows, coverage);
  return coverage;
}

/// Paint up to `x` of a film of depth 1 mm whose right edge is at `edge`: the ramp's integral.
double paint_left_of(double x, double edge) {
  const double w = static_cast<double>(kEdgeRise);
  const double from_edge = std::max(edge - x, 0.0);
  const double ramp = std::min(from_edge, w);
  return -1e-3 * (ramp * ramp / (2 * w) + std::max(from_edge - w, 0.0));
}
double film_depth(int x, double edge) {
  return paint_left_of(x + 1, edge) - paint_left_of(x, edge);
}

TEST(EdgeCoverage, IsTheShareThatARampCoversOfItsLastCell) {
  for (int tenth = 1; tenth <= 10; ++tenth) {
    const double edge = 6 + 0.1 * tenth;
    const double share = edge - 6;
    const auto along_x = coverage_of([&](int x, int) { return film_depth(x, edge); }, 5);
    // The cell behind the edge is a part of the ramp as well: 0.03 too much at most.
    EXPECT_NEAR(static_cast<double>(along_x[6]), share, 0.03) << share;
    EXPECT_EQ(along_x[5], 1);
    EXPECT_EQ(along_x[7], 1);  // bare
    // The same whichever way the film lies.
    const auto mirrored = coverage_of([&](int x, int) { return film_depth(11 - x, edge); }, 5);
    EXPECT_EQ(mirrored[5], along_x[6]);
    for (int y = 0; y < kCanvasSide; ++y) {
      const auto down = coverage_of([&](int, int v) { return film_depth(v, edge); }, y);
      const auto up = coverage_of([&](int, int v) { return film_depth(11 - v, edge); }, y);
      EXPECT_EQ(down[3], along_x[static_cast<std::size_t>(y)]) << y;
      EXPECT_EQ(up[3], mirrored[static_cast<std::size_t>(y)]) << y;
    }
  }
}

TEST(EdgeCoverage, IsWholeInsideAFilmWhateverItsRelief) {
  const auto relief = [](int x, int y) { return 2e-6 + 1e-3 * ((7 * x + 5 * y) % 11); };
  for (const float c : coverage_of(relief, 3)) EXPECT_EQ(c, 1);
  for (const float c : coverage_of([](int, int) { return 0.0; }, 3)) EXPECT_EQ(c, 1);
}

TEST(EdgeCoverage, APaintedCellAloneIsCovered) {
  const auto dot = [](int x, int y) { return x == 5 && y == 3 ? 2e-4 : 0.0; };
  for (const float c : coverage_of(dot, 3)) EXPECT_EQ(c, 1);
}

TEST(EdgeCoverage, ATraceBesideAFilmIsBare) {
  // Traces below a micrometre do not make the cell beside them an inner one.
  const auto film = [](int x, int) { return x < 6 ? 1e-3 : x == 6 ? 1e-4 : 0.9e-6; };
  const auto coverage = coverage_of(film, 3);
  EXPECT_NEAR(static_cast<double>(coverage[6]), std::sqrt(2 * 0.75 * 0.1), 1e-6);
  EXPECT_EQ(coverage[7], 1);
}

TEST(EdgeCoverage, GrowsWithTheDepthOfTheCellWithoutAStep) {
  float last = 0;
  for (int percent = 1; percent <= 100; ++percent) {
    const auto film = [&](int x, int) { return x < 6 ? 1e-3 : x == 6 ? 1e-5 * percent : 0.0; };
    const float c = coverage_of(film, 3)[6];
    EXPECT_GE(c, last);
    EXPECT_LT(c - last, percent > 1 ? 0.06f : 1.0f) << percent;  // sqrt from 1 to 2 %: 0.051
    last = c;
  }
  EXPECT_EQ(last, 1);
}

TEST(PartlyCovered, EndsAreTheGroundAndTheFilm) {
  for (const float k2 : {0.0f, 0.6f}) {
    EXPECT_NEAR(partly_covered(0.8f, 0.1f, 0, k2), 0.8f, 1e-6f);
    EXPECT_NEAR(partly_covered(0.8f, 0.1f, 1, k2), 0.1f, 1e-6f);
  }
  EXPECT_NEAR(partly_covered(0.8f, 0.2f, 0.5f, 0), 0.5f, 1e-6f);
}

}  // namespace
}  // namespace pentimento

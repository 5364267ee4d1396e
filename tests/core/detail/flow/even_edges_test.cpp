#include "core/detail/flow/even_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

namespace pentimento {
namespace {

constexpr int kEdgeSide = 48, kEnd = kEdgeSide - kEvenReach;

using EdgePlane = std::vector<float>;

float& edge_cell(EdgePlane& plane, int x, int y) {
  return plane[static_cast<std::size_t>(y * kEdgeSide + x)];
}

EdgePlane make_edge_plane(const std::function<float(int, int)>& value_at) {
  EdgePlane plane(kEdgeSide * kEdgeSide);
  for (int y = 0; y < kEdgeSide; ++y)
    for (int x = 0; x < kEdgeSide; ++x) edge_cell(plane, x, y) = value_at(x, y);
  return plane;
}

EdgePlane turned_edges(const EdgePlane& plane) {
  EdgePlane out = plane;
  for (int y = 0; y < kEdgeSide; ++y)
    for (int x = 0; x < kEdgeSide; ++x)
      out[static_cast<std::size_t>(x * kEdgeSide + y)] =
          plane[static_cast<std::size_t>(y * kEdgeSide + x)];
  return out;
}

EdgePlane mirrored_edges(EdgePlane plane) {
  for (auto row = plane.begin(); row != plane.end(); row += kEdgeSide)
    std::reverse(row, row + kEdgeSide);
  return plane;
}

/// Of a film whose coverage says where it is bare.
EdgePlane evened(const EdgePlane& coverage) {
  return even_edges(coverage, coverage, kEdgeSide, kEdgeSide);
}

/// A film on the left. Its edge slants: one cell to the right in `rows` rows. Cells are full or
/// bare, but for `last`, the share of the outermost ones.
EdgePlane staircase(int rows, float last) {
  return make_edge_plane([&](int x, int y) {
    const int end = 16 + y / rows;
    return x < end ? 1.0f : x == end ? last : 0.0f;
  });
}

/// How far the film reaches in each row.
std::vector<float> edge_reaches(EdgePlane plane) {
  std::vector<float> cells;
  for (int y = kEvenReach; y < kEnd; ++y) {
    float sum = 0;
    for (int x = 0; x < kEdgeSide; ++x) sum += edge_cell(plane, x, y);
    cells.push_back(sum);
  }
  return cells;
}

/// The largest distance of the reaches from the line through all of them.
float unevenness(const std::vector<float>& reaches) {
  const double n = static_cast<double>(reaches.size());
  double mean = 0, lean = 0, spread = 0;
  for (const float r : reaches) mean += r / n;
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    const double from_middle = static_cast<double>(i) - (n - 1) / 2;
    lean += from_middle * (reaches[i] - mean), spread += from_middle * from_middle;
  }
  double worst = 0;
  for (std::size_t i = 0; i < reaches.size(); ++i)
    worst = std::max(worst, std::abs(reaches[i] - mean -
                                     lean / spread * (static_cast<double>(i) - (n - 1) / 2)));
  return static_cast<float>(worst);
}

TEST(EvenEdges, AStaircaseBecomesALine) {
  for (const int rows : {2, 3, 4, 6, 8}) {
    const EdgePlane stairs = staircase(rows, 0.5f);
    // A step is half a cell off its line at both ends, but for half of a row.
    EXPECT_GT(unevenness(edge_reaches(stairs)), 0.2f) << rows;
    // The mean over two steps of eight rows leaves no more than a tenth.
    EXPECT_LT(unevenness(edge_reaches(evened(stairs))), 0.1f) << rows;
  }
}

TEST(EvenEdges, AStaircaseStaysWhereItIs) {
  // The line goes through the middles of the steps: what it takes at one end it gives at the other.
  for (const int rows : {2, 4, 7}) {
    const std::vector<float> before = edge_reaches(staircase(rows, 0.5f));
    const std::vector<float> after = edge_reaches(evened(staircase(rows, 0.5f)));
    double gain = 0;
    for (std::size_t i = 0; i < before.size(); ++i) gain += after[i] - before[i];
    // Two rows at each end see an unequal number of steps: a tenth of a cell each.
    EXPECT_NEAR(gain / static_cast<double>(before.size()), 0, 0.02) << rows;
  }
}

TEST(EvenEdges, StraightEdgesStay) {
  // But for rounding: a sum of five cells less two.
  const EdgePlane upright = make_edge_plane([](int x, int) {
    return x < 20 ? 1.0f : x == 20 ? 0.6f : 0.0f;
  });
  const EdgePlane slanting = make_edge_plane([](int x, int y) {
    return x + y < 48 ? 1.0f : x + y == 48 ? 0.4f : 0.0f;
  });
  for (const EdgePlane& plane : {upright, turned_edges(upright), slanting}) {
    const EdgePlane even = evened(plane);
    for (std::size_t i = 0; i < even.size(); ++i) EXPECT_NEAR(even[i], plane[i], 1e-6f) << i;
  }
}

TEST(EvenEdges, AllDirectionsAreAlike) {
  EdgePlane stairs = staircase(5, 0.7f), even = evened(stairs);
  EXPECT_NE(even, stairs);
  for (int quarter = 0; quarter < 4; ++quarter) {
    EXPECT_EQ(evened(turned_edges(stairs)), turned_edges(even));
    // Turned about the diagonal and mirrored: by a quarter.
    stairs = mirrored_edges(turned_edges(stairs)), even = mirrored_edges(turned_edges(even));
    EXPECT_EQ(evened(stairs), even) << quarter;
  }
}

TEST(EvenEdges, OnlyEdgesChange) {
  // Two films with two bare cells between them: each is even by itself, as if the other were not
  // there.
  const EdgePlane one = staircase(6, 0.5f);
  EdgePlane two = one;
  for (int y = 0; y < kEdgeSide; ++y)
    for (int x = 16 + y / 6 + 3; x < kEdgeSide; ++x) edge_cell(two, x, y) = 1;
  const EdgePlane even_one = evened(one);
  EdgePlane even_two = evened(two), expected = two;
  for (int y = kEvenReach; y < kEnd; ++y) {
    const int end = 16 + y / 6;
    edge_cell(expected, end, y) = even_one[static_cast<std::size_t>(y * kEdgeSide + end)];
    // The gap and the other film's first cell are edges too, of that film.
    for (int x = end + 1; x <= end + 4; ++x) edge_cell(expected, x, y) = edge_cell(even_two, x, y);
  }
  EXPECT_EQ(even_two, expected);
}

TEST(EvenEdges, APigmentsEdgeInsideTheFilmStays) {
  EdgePlane stairs = staircase(6, 0.5f), film(stairs.size(), 1.0f);
  EXPECT_EQ(even_edges(stairs, film, kEdgeSide, kEdgeSide), stairs);
  // Where the film ends with it, it is evened as the film is.
  for (int y = 24; y < kEdgeSide; ++y)
    for (int x = 17 + y / 6; x < kEdgeSide; ++x) edge_cell(film, x, y) = 0;
  EdgePlane some = even_edges(stairs, film, kEdgeSide, kEdgeSide), all = evened(stairs);
  EXPECT_NE(edge_cell(all, 19, 20), edge_cell(stairs, 19, 20));
  EXPECT_EQ(edge_cell(some, 19, 20), edge_cell(stairs, 19, 20));
  EXPECT_NE(edge_cell(all, 20, 26), edge_cell(stairs, 20, 26));
  EXPECT_EQ(edge_cell(some, 20, 26), edge_cell(all, 20, 26));
}

TEST(EvenEdges, NarrowFilmsStay) {
  // Lines across a film of three cells begin beyond its other side.
  for (const int rows : {1, 2, 3, 5}) {
    EdgePlane narrow = make_edge_plane([&](int x, int y) {
      const int from_middle = std::abs(x - 20 - y / rows);
      return from_middle == 0 ? 1.0f : from_middle == 1 ? 0.5f : 0.0f;
    });
    edge_cell(narrow, 14, 30) = 1;  // and a speck
    EXPECT_EQ(evened(narrow), narrow) << rows;
  }
}

TEST(EvenEdges, GroovesAndStripsStay) {
  // A groove a cell wide has no side to be evened, and neither has a strip of two cells between
  // two grooves: there the film does not fall off, or a line would begin across a groove.
  for (const int rows : {1, 2, 3, 5}) {
    const EdgePlane groove =
        make_edge_plane([&](int x, int y) { return x == 16 + y / rows ? 0.3f : 1.0f; });
    EXPECT_EQ(evened(groove), groove) << rows;
    const EdgePlane strip = make_edge_plane([&](int x, int y) {
      const int from_first = x - 16 - y / rows;
      return from_first == 0 || from_first == 3 ? 0.0f : 1.0f;
    });
    EXPECT_EQ(evened(strip), strip) << rows;
  }
}

TEST(EvenEdges, AFoldOfAnEdgeStays) {
  // The film stands back around row 24, by a third of a cell a row: a fold, not a step. The mean
  // ends at three rows there, where the edge is one cell further; over eight it would fill the fold
  // with a third of a cell.
  const EdgePlane fold = make_edge_plane([](int x, int y) {
    const float end = 20.5f + static_cast<float>(std::abs(y - 24)) / 3;
    return std::clamp(end - static_cast<float>(x), 0.0f, 1.0f);
  });
  EdgePlane even = evened(fold);
  EXPECT_NEAR(edge_cell(even, 20, 24), 0.5f + 0.417f, 1e-3f);  // the mean of 0, 1, 2 and 3 thirds
  EXPECT_EQ(edge_cell(even, 21, 24), 0);
}

TEST(EvenEdges, WetCellsStayInside) {
  // A spur of one cell at a straight edge: the line takes it away, but for a tenth.
  EdgePlane spur = make_edge_plane([](int x, int) { return x < 20 ? 1.0f : 0.0f; });
  edge_cell(spur, 20, 24) = 0.5f;
  EdgePlane even = evened(spur);
  EXPECT_EQ(edge_cell(even, 20, 24), 0.1f);
  EXPECT_LT(edge_cell(even, 20, 25), 0.06f);  // an eighth of the spur, at most
}

TEST(EvenEdges, ARoundFilmStaysRound) {
  // The mean ends where the edge bends. A disc loses a tenth of a cell all around, at most.
  for (const float radius : {6.0f, 12.5f, 20.0f}) {
    const EdgePlane disc = make_edge_plane([&](int x, int y) {
      const float r = std::hypot(static_cast<float>(x) - 23.5f, static_cast<float>(y) - 23.5f);
      return std::clamp(radius - r, 0.0f, 1.0f);
    });
    const EdgePlane even = evened(disc);
    double lost = 0;
    for (std::size_t i = 0; i < disc.size(); ++i) lost += disc[i] - even[i];
    EXPECT_NEAR(lost / (2 * 3.14159 * radius), 0, 0.1) << radius;
  }
}

}  // namespace
}  // namespace pentimento

#include "core/detail/flow/fine_remap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/detail/flow/fine_edges.h"
#include "core/fluid/conservative/advection/limiter.h"

namespace pentimento {
namespace {

std::vector<float> moved(const std::vector<float>& position, const std::vector<float>& amount) {
  FineSources sources;
  find_sources(position, sources);
  std::vector<float> padded = {amount.front()};
  padded.insert(padded.end(), amount.begin(), amount.end());
  padded.push_back(amount.back());
  std::vector<float> part(amount.size() + 1), out(amount.size());
  remap_line(sources, padded, part, out);
  return out;
}

double sum(const std::vector<float>& v) {
  double s = 0;
  for (const float x : v) s += static_cast<double>(x);
  return s;
}

/// remap_line() by its equations, cell by cell.
std::vector<float> plainly_moved(const FineSources& sources, const std::vector<float>& amount) {
  const int n = static_cast<int>(amount.size());
  const auto m = [&](int i) { return amount[static_cast<std::size_t>(std::clamp(i, 0, n - 1))]; };
  const auto part = [&](int j) {
    const int i = sources.cell[static_cast<std::size_t>(j)];
    const float s = sources.share[static_cast<std::size_t>(j)];
    const float slope = conservative::limited_mc(m(i) - m(i - 1), m(i + 1) - m(i));
    return s * (m(i) - 0.5f * slope * (1 - s));
  };
  std::vector<float> out;
  for (int j = 0; j < n; ++j) {
    float sum = part(j + 1) - part(j);
    for (int i = sources.cell[static_cast<std::size_t>(j)];
         i < sources.cell[static_cast<std::size_t>(j + 1)]; ++i)
      sum += m(i);
    out.push_back(sum > 0 ? sum : 0.0f);
  }
  return out;
}

TEST(RemapLine, EdgesInStepAndOthersMoveAsTheEquationsSay) {
  // Lines of whole pieces and others. Between still walls the edges go back by 1.3 cells, then they
  // stand still, then they go on by 5.6 cells and come closer again.
  for (const std::size_t cells : {15u, 16u, 17u, 96u, 133u}) {
    std::vector<float> position(cells + 1), amount(cells);
    const auto n = static_cast<float>(cells);
    for (std::size_t e = 0; e <= cells; ++e) {
      const float at = static_cast<float>(e), t = at / n;
      const float ramp = std::min({1.0f, 10 * t, 10 * (0.5f - t)});
      const float far = std::min({1.0f, 4 * (t - 0.6f), 40 * (1 - t)});
      position[e] = at + (t < 0.5f ? -1.3f * ramp : t > 0.6f ? 5.6f * far : 0.0f);
    }
    position.front() = 0;
    position.back() = n;
    for (std::size_t i = cells; i-- > 1;)  // they ascend
      position[i] = std::min(position[i], position[i + 1] - 1.0f / 64);
    for (std::size_t i = 1; i < cells; ++i)
      position[i] = std::max(position[i], position[i - 1] + 1.0f / 64);
    for (std::size_t i = 0; i < cells; ++i) amount[i] = 1 + static_cast<float>(i * 7919 % 101) / 50;
    FineSources sources;
    find_sources(position, sources);
    EXPECT_EQ(moved(position, amount), plainly_moved(sources, amount)) << cells;
    if (cells < 96) continue;
    EXPECT_GT(std::count(sources.in_step.begin(), sources.in_step.end(), 1), 0);
    EXPECT_GT(std::count(sources.in_step.begin(), sources.in_step.end(), 0), 1);
    EXPECT_GT(sources.most, 2);
    // Pieces of all three kinds.
    std::size_t near = 0, neither = 0;
    for (std::size_t i = 0; i < sources.near.size(); ++i) {
      if (sources.in_step[i] != 0) continue;
      (sources.near[i] != kNotNear ? near : neither) += 1;
    }
    EXPECT_GT(near, 0);
    EXPECT_GT(neither, 0);
  }
}

// Edges that come from a tenth more or less far: nearly all pieces are near. Cells beside bare ones
// and cells alone show what is read beside a source.
TEST(RemapLine, EdgesThatAreNearMoveAsTheEquationsSay) {
  constexpr std::size_t kCells = 160;
  for (const float drift : {-2.7f, -0.4f, 0.0f, 0.6f, 3.5f}) {
    std::vector<float> position(kCells + 1), amount(kCells);
    for (std::size_t e = 1; e < kCells; ++e) {
      const float at = static_cast<float>(e);
      const float from_wall = std::min({1.0f, at / 20, (kCells - at) / 20});
      position[e] = at + from_wall * drift + 0.1f * static_cast<float>(e * 7 % 5);
    }
    position[kCells] = kCells;
    for (std::size_t i = 0; i < kCells; ++i)
      amount[i] = i % 13 == 4 ? 0 : i % 29 == 7 ? 40.0f : 1 + static_cast<float>(i * 31 % 17) / 9;
    FineSources sources;
    find_sources(position, sources);
    EXPECT_EQ(moved(position, amount), plainly_moved(sources, amount)) << drift;
    EXPECT_GE(std::count(sources.near.begin(), sources.near.end(), kNotNear), 1) << "the last";
    EXPECT_LE(std::count(sources.near.begin(), sources.near.end(), kNotNear), 3) << drift;
  }
}

TEST(FindSources, KnowsWhichEdgesAreNear) {
  const auto near = [](std::size_t edges, const auto& moved_by) {
    std::vector<float> position(edges);
    for (std::size_t e = 0; e < edges; ++e)
      position[e] = static_cast<float>(e) + moved_by(static_cast<int>(e));
    FineSources sources;
    find_sources(position, sources);
    return sources.near;
  };
  // All edges stand: each comes from the cell behind it.
  EXPECT_EQ(near(50, [](int) { return 0.0f; }), (std::vector<int>{0, 16, 32, kNotNear}));
  // The edges 20 to 25 come from the cell before: that, seen from the piece's first edge.
  EXPECT_EQ(near(50, [](int e) { return e >= 20 && e < 26 ? 0.5f : 0.0f; })[1], 15);
  // From two cells before: too far.
  EXPECT_EQ(near(50, [](int e) { return e >= 20 && e < 26 ? 1.5f : 0.0f; })[1], kNotNear);
  // A whole piece at the end, behind whose sources no cell is left but the ghost.
  EXPECT_EQ(near(34, [](int) { return 0.0f; }), (std::vector<int>{0, 16, kNotNear}));
  EXPECT_EQ(near(33, [](int) { return 0.0f; }), (std::vector<int>{0, kNotNear, kNotNear}));
}

TEST(FindSources, KnowsWhichEdgesAreInStep) {
  // 40 edges; the edges 16 to 23 come from a cell back: their piece is not in step, nor is the one
  // before it, whose last edge lies beside it, nor the last, which is not whole.
  std::vector<float> position(40);
  for (std::size_t e = 0; e < position.size(); ++e)
    position[e] = static_cast<float>(e) + (e >= 15 && e < 23 ? 0.25f : 0.0f);
  FineSources sources;
  find_sources(position, sources);
  EXPECT_EQ(sources.in_step, (std::vector<std::uint8_t>{0, 0, 0}));
  for (std::size_t e = 0; e < position.size(); ++e)
    position[e] = static_cast<float>(e) + (e >= 18 && e < 23 ? 0.25f : 0.0f);
  find_sources(position, sources);
  EXPECT_EQ(sources.in_step, (std::vector<std::uint8_t>{1, 0, 0}));
}

TEST(RemapLine, LeavesWhatStandsStill) {
  const std::vector<float> amount = {1, 4, 2, 8, 5};
  EXPECT_EQ(moved({0, 1, 2, 3, 4, 5}, amount), amount);
}

TEST(RemapLine, MovesWholeCellsExactly) {
  // The second and third cell go three cells on; what was there is pressed against the wall.
  const std::vector<float> amount = {0, 2, 6, 0, 0, 0, 0, 0};
  const std::vector<float> out = moved({0, 4, 5, 6, 6.5f, 7, 7.5f, 7.75f, 8}, amount);
  EXPECT_FLOAT_EQ(out[4], 2);
  EXPECT_FLOAT_EQ(out[5], 6);
}

TEST(FindSources, AreWhereEachEdgeCameFrom) {
  // The edge at j came from cell i: its place is between the positions of that cell's edges.
  const std::vector<float> position = {0, 2.5f, 2.75f, 3, 3.5f, 7, 8};
  FineSources sources;
  find_sources(position, sources);
  EXPECT_EQ(sources.cell, (std::vector<int>{0, 0, 0, 3, 4, 4, 5}));
  const float expected[] = {0, 0.4f, 0.8f, 0, 0.5f / 3.5f, 1.5f / 3.5f, 1};
  for (std::size_t j = 0; j < position.size(); ++j)
    EXPECT_FLOAT_EQ(sources.share[j], expected[j]) << j;
  EXPECT_EQ(sources.most, 3);
  // At both ends of the line too.
  find_sources(std::vector<float>{0, 0.25f, 0.5f, 0.75f, 4}, sources);
  EXPECT_EQ(sources.most, 3);
  find_sources(std::vector<float>{0, 3.25f, 3.5f, 3.75f, 4}, sources);
  EXPECT_EQ(sources.most, 3);
}

TEST(RemapLine, KeepsSumsAndSigns) {
  std::vector<float> guide = {0, 0.4f, -0.9f, 1.3f, 0.2f, 0}, amount(40), position(41);
  place_edges(guide, 8, position);
  for (std::size_t i = 0; i < amount.size(); ++i) amount[i] = i % 7 == 0 ? 3.0f : 0.01f;
  const std::vector<float> out = moved(position, amount);
  EXPECT_NEAR(sum(out) / sum(amount), 1, 1e-6);  // float rounding of forty differences
  for (const float value : out) EXPECT_GE(value, 0);
}

TEST(RemapLine, IsSecondOrderWhereSmooth) {
  // A wave that moves by 2.3 cells inside still walls: the error falls by about four per halving.
  const auto error = [](int n) {
    std::vector<float> amount(static_cast<std::size_t>(n)), position(amount.size() + 1);
    const double shift = 0.023, pi = 3.14159265358979;
    const auto bump = [&](double x) {
      return x > 0.2 && x < 0.6 ? std::pow(std::sin((x - 0.2) / 0.4 * pi), 4) : 0.0;
    };
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / n;
      const double ramp = std::min({1.0, x * 10, (1 - x) * 10});
      position[static_cast<std::size_t>(i)] = static_cast<float>(i + shift * n * ramp);
      if (i < n) amount[static_cast<std::size_t>(i)] = static_cast<float>(bump((i + 0.5) / n));
    }
    const std::vector<float> out = moved(position, amount);
    double off = 0;
    for (int i = 0; i < n; ++i)
      off += std::abs(static_cast<double>(out[static_cast<std::size_t>(i)]) -
                      bump((i + 0.5) / n - shift)) /
             n;
    return off;
  };
  EXPECT_GT(std::log2(error(50) / error(200)) / 2, 1.6);  // limiter flattens the crest
}

}  // namespace
}  // namespace pentimento

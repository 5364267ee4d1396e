#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/fluid/conservative/advection/crowd_limit.h"
#include "core/fluid/conservative/tiles/quantum.h"
#include "tests/core/fluid/conservative/plain_remap.h"

namespace pentimento::conservative {
namespace {

constexpr float kQuantum = 0x1p-26f;

/// Moves `value` once; `edge` in cells.
std::vector<float> moved(const std::vector<float>& value, const std::vector<float>& edge,
                         int step = 1, bool superbee = false, float quantum = kQuantum) {
  RemapPlan plan;
  const int n = static_cast<int>(value.size());
  plan.resize(n, step);
  plan.edge = edge;
  plan_remap(plan);
  RemapScratch scratch;
  scratch.resize(n, step);
  std::copy(value.begin(), value.end(), scratch.cells(scratch.value, step));
  remap_batch(plan, {superbee, rounder_for(quantum)}, scratch);
  const float* out = scratch.cells(scratch.value, step);
  return {out, out + n};
}

float whole(float value) {
  return rounded(value, rounder_for(kQuantum));
}

TEST(Remap, MovesByHand) {
  // Half a cell to the right, flat profile: half of each cell goes over its high edge.
  const std::vector<float> out = moved({0, 1, 0, 0}, {0, 0.5f, 0.5f, 0.5f, 0}, 1, false, 0);
  EXPECT_EQ(out, (std::vector<float>{0, 0.5f, 0.5f, 0}));
}

TEST(Remap, PlansUpToACellAndSixtyFourthsOfOne) {
  struct Cell {
    float lo, hi, tau_lo, tau_hi, stay;
  };
  constexpr float kMore = 1 + 0x1p-20f;
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Cell cells[] = {{0, 0, 0, 0, 1},
                        {-0.0f, -0.0f, 0, 0, 1},
                        {-0.5f, 0.5f, 0.25f, 0.25f, 1},
                        {-1, 1, 1.0f / 3, 1.0f / 3, 1},      // to the ends of both neighbours
                        {1, 1, 0, 1, 1},                     // wholly into the next
                        {-1, -1, 1, 0, 1},                   // wholly into the one before
                        {-kMore, -1, 0, 0, 0},               // beyond
                        {1, kMore, 0, 0, 0},                 // beyond
                        {0.984375f, 0, 0, 0, 1},             // a sixty-fourth is left of it
                        {0.984375f + 0x1p-20f, 0, 0, 0, 0},  // less
                        {1, -1, 0, 0, 0},                    // its edges change order
                        {-80, 80, 0, 0, 0},
                        {0, kInfinity, 0, 0, 0},
                        {-kInfinity, 0, 0, 0, 0}};
  for (const Cell& cell : cells) {
    // Many side by side, for vectors, and one more.
    constexpr int kCells = 33;
    const std::vector<float> lo(kCells, cell.lo), hi(kCells, cell.hi);
    std::vector<float> tau_lo(kCells), tau_hi(kCells), stay(kCells);
    plan_remap_row(lo.data(), hi.data(), kCells, tau_lo.data(), tau_hi.data(), stay.data());
    for (std::size_t i = 0; i < kCells; ++i) {
      EXPECT_EQ(tau_lo[i], cell.tau_lo) << cell.lo << ' ' << cell.hi;
      EXPECT_EQ(tau_hi[i], cell.tau_hi) << cell.lo << ' ' << cell.hi;
      EXPECT_EQ(stay[i], cell.stay) << cell.lo << ' ' << cell.hi;
    }
    EXPECT_EQ(count_far_row(stay.data(), kCells), cell.stay == 0 ? kCells : 0);
  }
}

TEST(Remap, MovesWholeCellsExactly) {
  const std::vector<float> out = moved({0, 1, 3, 0, 0, 0, 0}, {0, 3, 3, 3, 3, 3, 3, 0});
  EXPECT_EQ(out[4], 1.0f);
  EXPECT_EQ(out[5], 3.0f);
}

TEST(Remap, KeepsTheSumAndNothingIsNegativeAtAnyCourantNumber) {
  for (const float speed : {0.01f, 0.4f, 0.99f, 1.0f, 1.7f, 20.0f, 80.0f})
    for (const bool superbee : {false, true})
      for (const int step : {1, 5}) {
        const int n = 40 * step;
        std::vector<float> value(static_cast<std::size_t>(n));
        std::vector<float> edge(static_cast<std::size_t>(n + step), 0.0f);
        for (int i = 0; i < n; ++i)
          value[static_cast<std::size_t>(i)] =
              whole(i % 3 == 0 ? 0.0f : 0.01f * std::abs(std::sin(0.7f * static_cast<float>(i))));
        for (int e = step; e < n; ++e)  // converging, diverging and crossing
          edge[static_cast<std::size_t>(e)] = speed * std::sin(0.9f * static_cast<float>(e));
        const auto out = moved(value, edge, step, superbee);
        EXPECT_EQ(std::accumulate(out.begin(), out.end(), 0.0),
                  std::accumulate(value.begin(), value.end(), 0.0))
            << speed;
        EXPECT_GE(*std::min_element(out.begin(), out.end()), 0.0f) << speed;
      }
}

TEST(Remap, FarCellsLandWhereNearOnesDo) {
  // The same displacement just below and just above one cell: the two paths of the code.
  std::vector<float> value(32, 0.0f);
  for (int i = 8; i < 20; ++i)
    value[static_cast<std::size_t>(i)] = 1 + 0.3f * std::sin(static_cast<float>(i));
  std::vector<float> near(33, 0.999999f), far(33, 1.000001f);
  near.front() = near.back() = far.front() = far.back() = 0;
  const auto a = moved(value, near, 1, false, 0);
  const auto b = moved(value, far, 1, false, 0);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-5f) << i;  // 2e-6 x value
}

TEST(Remap, IsSecondOrderWhereSmooth) {
  // A bell carried a quarter of the line in steps of half a cell; L1 against the exact bell.
  const auto error = [](int n) {
    std::vector<float> value(static_cast<std::size_t>(n));
    const auto bell = [&](double x) { return std::exp(-100 * (x - 0.35) * (x - 0.35)); };
    for (int i = 0; i < n; ++i)
      value[static_cast<std::size_t>(i)] = static_cast<float>(bell((i + 0.5) / n));
    std::vector<float> edge(static_cast<std::size_t>(n + 1), 0.5f);
    edge.front() = edge.back() = 0;
    for (int k = 0; k < n / 2; ++k) value = moved(value, edge, 1, false, 0);
    double sum = 0;
    for (int i = 0; i < n; ++i)
      sum += std::abs(static_cast<double>(value[static_cast<std::size_t>(i)]) -
                      bell((i + 0.5) / n - 0.25));
    return sum / n;
  };
  EXPECT_GT(std::log2(error(100) / error(200)), 1.7);  // 2 less the clipped top of the bell
}

TEST(Remap, KeepsAUniformVelocityUniform) {
  RemapPlan plan;
  plan.resize(30, 1);
  for (int e = 1; e < 30; ++e) plan.edge[static_cast<std::size_t>(e)] = 0.6f;
  plan_remap(plan);
  RemapScratch scratch;
  scratch.resize(30, 1);
  for (int i = 0; i < 30; ++i) {
    scratch.cells(scratch.value, 1)[i] = 0.01f * static_cast<float>(1 + i % 4);
    scratch.cells(scratch.momentum, 1)[i] = 0.25f;
  }
  remap_momentum_batch(plan, {}, scratch);
  for (int i = 1; i < 30; ++i)
    EXPECT_NEAR(scratch.cells(scratch.momentum, 1)[i], 0.25f, 1e-6f) << i;
}

TEST(CrowdLimit, NoCellIsDeeperThanMostAfterMoving) {
  const int n = 64;
  std::vector<float> padded(n + 2), edge(n + 1, 0.0f);
  for (int i = 0; i < n + 2; ++i)
    padded[static_cast<std::size_t>(i)] =
        whole(0.02f + 0.015f * std::sin(0.5f * static_cast<float>(i)));
  for (int e = 1; e < n; ++e)  // everything runs into the middle and through it
    edge[static_cast<std::size_t>(e)] = 0.9f * static_cast<float>(n / 2 - e);
  ASSERT_TRUE(limit_crowding({n, 1, 0.05f}, padded.data() + 1, edge.data()));
  const auto out = moved({padded.begin() + 1, padded.end() - 1}, edge);
  EXPECT_LE(*std::max_element(out.begin(), out.end()), 0.05f * 1.0001f);  // rounding of edges
  EXPECT_EQ(edge.front(), 0.0f);
  EXPECT_EQ(edge.back(), 0.0f);
}

TEST(CrowdLimit, LeavesFreeMotionAlone) {
  std::vector<float> depth(12, 0.001f), edge{0, 0.1f, 0.3f, 0.2f, 0, -0.4f, 0, 0, 0, 0, 0};
  const std::vector<float> before = edge;
  EXPECT_FALSE(limit_crowding({10, 1, 0.05f}, depth.data() + 1, edge.data()));
  EXPECT_EQ(edge, before);
}

}  // namespace
}  // namespace pentimento::conservative

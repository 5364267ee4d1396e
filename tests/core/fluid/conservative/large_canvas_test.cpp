#include <gtest/gtest.h>

#include <cstring>

#include "core/base/give_back.h"
#include "core/fluid/conservative/solve/workspace.h"
#include "tests/core/base/resident_memory.h"
#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

constexpr int kWidth = 256, kHeight = 192;  // of the part that is compared

// A blob of runny paint near the upper left corner of a canvas of cells of a millimetre, on a film
// that is too thin to move, so that all cells are wet.
Basin blob_on(int width, int height) {
  Basin b({width, height, 0.001 * width, 0.001 * height});
  b.fill_depth([](int, int) { return 0x1p-17f; });
  for (int y = 60; y < 100; ++y)
    for (int x = 100; x < 140; ++x) {
      b.state.depth_m(x, y) = 0.002f;
      b.state.channel(0, 0)(x, y) = 0.004f;
    }
  return b;
}

::testing::AssertionResult same_part(const Basin& a, const Basin& b) {
  for (const auto& [mine, its] : {std::pair{&a.state.depth_m, &b.state.depth_m},
                                  {&a.state.velocity_x_m_s, &b.state.velocity_x_m_s},
                                  {&a.state.velocity_y_m_s, &b.state.velocity_y_m_s},
                                  {&a.state.channel(0, 0), &b.state.channel(0, 0)}})
    for (int y = 0; y < kHeight; ++y)
      if (std::memcmp(mine->row(y), its->row(y), kWidth * sizeof(float)) != 0)
        return ::testing::AssertionFailure() << "row " << y;
  return ::testing::AssertionSuccess();
}

TEST(LargeCanvas, GivesBackTheMemoryOfWhatSleepsAndPaintsAsASmallOneDoes) {
  Basin small = blob_on(kWidth, kHeight), large = blob_on(2560, 2048);
  small.steps(1);
  large.steps(1);  // all is awake once, and computed
  const long before_mib = resident_mib();
  // It runs over, rests, and is left alone for long enough; ...
  small.steps(4 * kStepsBetweenGivingBack);
  large.steps(4 * kStepsBetweenGivingBack);
  EXPECT_TRUE(same_part(small, large));
  // 21 planes of work and seven of the solver, of 20 MiB each.
  if (!is_marked_when_given()) {
    EXPECT_LT(resident_mib() - before_mib, -400);
  }
  // ... then it runs on.
  const float deepest_m = highest(small.state.depth_m);
  small.gravity_m_s2 = large.gravity_m_s2 = {0, -6.9f, 6.9f};
  small.steps(30);
  large.steps(30);
  EXPECT_NE(highest(small.state.depth_m), deepest_m);
  EXPECT_GT(highest(small.state.velocity_y_m_s), 1e-3f);
  EXPECT_TRUE(same_part(small, large));
}

TEST(Workspace, WhatLiesBeyondTheCanvasStaysWhenMemoryIsGivenBack) {
  const CanvasGeometry g = {1024, 64, 1.024, 0.064};
  Workspace w(g);
  w.height_m.row(40)[500] = 1;
  w.give_back({0, 1024, 0, 64});
  EXPECT_EQ(w.height_m.row(40)[500], 0.0f);
  for (int i = 0; i < g.width; ++i) {
    EXPECT_EQ(w.x.depth_m.row(-1)[i], -1.0f);
    EXPECT_EQ(w.x.depth_m.row(g.height)[i], -1.0f);
  }
  for (int j = 0; j < g.height; ++j) {
    EXPECT_EQ(w.y.depth_m.row(j)[-1], -1.0f);
    EXPECT_EQ(w.y.depth_m.row(j)[g.width], -1.0f);
  }
  // Of a part, what lies beside it stays.
  for (int x = 0; x < g.width; ++x) w.height_m.row(20)[x] = 2;
  w.give_back({256, 768, 0, 64});
  for (int x = 0; x < g.width; ++x)
    if (x < 256 || x >= 768) {
      EXPECT_EQ(w.height_m.row(20)[x], 2.0f);
    }
}

}  // namespace
}  // namespace pentimento::conservative

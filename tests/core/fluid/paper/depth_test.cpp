#include "core/fluid/paper/depth.h"

#include <gtest/gtest.h>

#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {
namespace {

TEST(UpdateDepthRow, WhatIsNoFilmIsBarePaperAndWhatDidNotMoveStays) {
  CanvasState state = make_canvas_state({9, 3, 0.009, 0.003}, 1, 1, 3, 0.9f);
  Planes planes = make_planes(9, 3, 1);
  planes.moved.fill(0);
  planes.moved(1, 1) = 1;  // so the cells 0 and 2 beside it follow their height, too
  state.base_m.fill(0);
  state.base_m(0, 1) = 0.5f;
  state.depth_m.fill(0.125f);
  Field<float> height(9, 3, 0.75f);
  height(1, 1) = 0.5f * kNoFilm_m;
  height(2, 1) = -0.25f;
  EXPECT_TRUE(update_depth_row(planes, height, 1, {0, 9}, state));
  EXPECT_EQ(state.depth_m(0, 1), 0.25f);  // above its base
  EXPECT_EQ(state.depth_m(1, 1), 0);
  EXPECT_EQ(state.depth_m(2, 1), 0);
  for (int x = 3; x < 9; ++x) EXPECT_EQ(state.depth_m(x, 1), 0.125f) << x;
}

}  // namespace
}  // namespace pentimento::paper

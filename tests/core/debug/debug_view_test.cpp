#include "core/debug/debug_view.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/canvas/canvas_state.h"
#include "tests/core/canvas/set_base.h"

namespace pentimento {
namespace {

/// Four cells in a row, two layers, two channels of which each counts whole.
struct Cells {
  Cells() : state(make_canvas_state({4, 1, 0.4, 0.1}, 2, 2, 3, 1.0f)) {
    basis.name = {"a", "b"};
    basis.amount = Eigen::VectorXf::Ones(2);
  }
  std::vector<float> values(DebugView view, std::vector<std::int8_t>* marks = nullptr) const {
    const StateSource canvas(state);
    const DebugColors colors(view, {});
    DebugRows rows(colors, canvas, basis);
    std::vector<float> value(4);
    std::vector<std::int8_t> mark(4);
    rows.read(0, value, mark);
    if (marks != nullptr) *marks = mark;
    return value;
  }
  std::vector<Linear3> colors(DebugView view, const DebugScale& scale) const {
    const StateSource canvas(state);
    const DebugColors debug(view, scale);
    DebugRows rows(debug, canvas, basis);
    std::vector<Linear3> out(4);
    rows.paint(0, out);
    return out;
  }
  DebugScale scale(DebugView view) const {
    return measure_debug_scale(view, StateSource(state), basis);
  }

  CanvasState state;
  ChannelBasis basis;
};

TEST(DebugView, HeightIsBaseAndWetPaint) {
  Cells cells;
  set_base(cells.state, 1, 0, 0.25f);
  cells.state.depth_m(1, 0) = 0.5f;
  EXPECT_EQ(cells.values(DebugView::kHeight), (std::vector<float>{0, 0.75f, 0, 0}));
}

TEST(DebugView, VelocityIsSpeedAndItsHueDirection) {
  Cells cells;
  cells.state.velocity_x_m_s(0, 0) = 3;
  cells.state.velocity_y_m_s(0, 0) = 4;
  cells.state.velocity_x_m_s(1, 0) = 5;
  cells.state.velocity_y_m_s(2, 0) = -5;  // up, as seen
  EXPECT_EQ(cells.values(DebugView::kVelocity), (std::vector<float>{5, 5, 5, 0}));
  const auto seen = cells.colors(DebugView::kVelocity, {0, 5, 1, ""});
  EXPECT_EQ(seen[1], linear_of({255, 0, 0}));
  // A quarter of the circle on: between red and green, nearer to green.
  EXPECT_GT(seen[2][1], seen[2][0]);
  EXPECT_EQ(seen[2][2], 0);
  EXPECT_EQ(seen[3], linear_of({24, 24, 24}));
}

TEST(DebugView, PigmentIsTheSumOverLayersByTheBasisAmounts) {
  Cells cells;
  cells.basis.amount(1) = 0;  // an optical channel
  cells.state.channel(0, 0)(2, 0) = 0.25f;
  cells.state.channel(1, 0)(2, 0) = 0.5f;
  cells.state.channel(1, 1)(2, 0) = 100;
  EXPECT_EQ(cells.values(DebugView::kPigment), (std::vector<float>{0, 0, 0.75f, 0}));
}

TEST(DebugView, LayersCountsThoseThatHoldPigment) {
  Cells cells;
  cells.state.channel(0, 0)(1, 0) = 0.1f;
  cells.state.channel(0, 1)(2, 0) = 0.1f;
  cells.state.channel(1, 0)(2, 0) = 0.1f;
  cells.state.channel(1, 0)(3, 0) = 1e-8f;  // counts as empty
  EXPECT_EQ(cells.values(DebugView::kLayers), (std::vector<float>{0, 1, 2, 0}));
  EXPECT_EQ(cells.scale(DebugView::kLayers).to, 2);
}

TEST(DebugView, WetnessTellsWetFromDriedAndBare) {
  Cells cells;
  cells.state.depth_m(0, 0) = 1e-3f;
  set_base(cells.state, 1, 0, 1e-4f);
  std::vector<std::int8_t> mark;
  EXPECT_EQ(cells.values(DebugView::kWetness, &mark)[0], 1e-3f);
  EXPECT_EQ(mark, (std::vector<std::int8_t>{-1, 1, 0, 0}));
  const auto seen = cells.colors(DebugView::kWetness, {0, 1e-3, 1e-3, "mm"});
  const auto apart = DebugColors(DebugView::kWetness, {}).swatches();
  EXPECT_EQ(seen[0], color_at(blues(), 1));
  EXPECT_EQ(seen[1], linear_of(apart[1].color));
  EXPECT_EQ(seen[2], linear_of(apart[0].color));
}

TEST(DebugView, TheScaleIsRoundAndHoldsEveryValue) {
  Cells cells;
  const auto up_to = [&](float most) {
    set_base(cells.state, 3, 0, most);
    return cells.scale(DebugView::kHeight);
  };
  EXPECT_DOUBLE_EQ(up_to(0.0013f).to, 0.002);
  EXPECT_DOUBLE_EQ(up_to(0.0023f).to, 0.005);
  EXPECT_DOUBLE_EQ(up_to(0.0051f).to, 0.01);
  EXPECT_DOUBLE_EQ(up_to(0.001f).to, 0.001);
  EXPECT_EQ(up_to(0.001f).from, 0);
  EXPECT_EQ(up_to(0.001f).unit, "mm");
  set_base(cells.state, 0, 0, -0.0003f);
  EXPECT_DOUBLE_EQ(up_to(0.001f).from, -0.0005);
  EXPECT_EQ(Cells().scale(DebugView::kVelocity).to, 1e-3);  // nothing moves
}

TEST(DebugView, WhatIsNotFiniteIsMagentaAndNotMeasured) {
  Cells cells;
  cells.state.depth_m(1, 0) = std::numeric_limits<float>::quiet_NaN();
  cells.state.velocity_x_m_s(2, 0) = std::numeric_limits<float>::infinity();
  cells.state.depth_m(3, 0) = 0.002f;
  EXPECT_DOUBLE_EQ(cells.scale(DebugView::kHeight).to, 0.002);
  const Linear3 magenta = linear_of(kNotFiniteColor);
  EXPECT_EQ(cells.colors(DebugView::kHeight, {0, 0.002, 1, ""})[1], magenta);
  EXPECT_EQ(cells.colors(DebugView::kWetness, {0, 0.002, 1, ""})[1], magenta);
  EXPECT_EQ(cells.colors(DebugView::kVelocity, {0, 1, 1, ""})[2], magenta);
}

TEST(DebugView, APlaceOnTheBarIsThatOfItsValue) {
  for (const DebugView view : {DebugView::kHeight, DebugView::kVelocity, DebugView::kPigment}) {
    const DebugColors colors(view, {0, 0.02, 1, ""});
    for (const double share : {0.0, 0.25, 1.0})
      EXPECT_NEAR(colors.share_of(colors.value_at(share)), share, 1e-12);  // rounding
  }
  // Half the bar is a quarter of the speed.
  EXPECT_NEAR(DebugColors(DebugView::kVelocity, {0, 2, 1, ""}).value_at(0.5), 0.5, 1e-12);
}

}  // namespace
}  // namespace pentimento

#include "core/brush/edge_cells.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/brush/builtin_brushes.h"
#include "tests/core/canvas/set_base.h"

namespace pentimento {
namespace {

constexpr CanvasGeometry kSheet = {60, 40, 0.06, 0.04};  // cells of a millimetre

/// A knife of 20 mm, whose sides are sharp, drawn along `angle` while its length lies along `turn`.
StampPlan plan_at(const Tip& tip, double turn, double way) {
  StampPlan plan;
  plan.tip = &tip;
  plan.pose.diameter_m = 0.02f;
  plan.pose.u_x = static_cast<float>(std::cos(turn) / 0.02);
  plan.pose.u_y = static_cast<float>(std::sin(turn) / 0.02);
  plan.pose.v_x = static_cast<float>(-std::sin(turn) / 0.02);
  plan.pose.v_y = static_cast<float>(std::cos(turn) / 0.02);
  plan.stamp.direction = {static_cast<float>(std::cos(way)), static_cast<float>(std::sin(way))};
  return plan;
}

TEST(EdgeCells, ACellAtTheSideIsPassedAsFarAsTheTipReaches) {
  const Tip knife(*builtin_brush("knife"));
  // The knife's value falls from 1 at 0.485 to 0 at 0.5, so its side is about there: the table has
  // steps of 0.008, and a cell is 0.05 wide.
  for (const double turn : {0.0, 0.6, 1.5}) {
    const BristleTable share = passed_shares(plan_at(knife, turn, turn), kSheet);
    EXPECT_EQ(share.at(0), 1) << turn;
    EXPECT_NEAR(share.at(-0.4f), 1, 1e-5f) << turn;
    for (const float v : {0.46f, 0.475f, 0.49f, 0.499f}) {
      const float side = 0.495f;
      EXPECT_NEAR(share.at(v), std::min(1.0f, 0.5f + (side - v) / 0.05f), 0.1f)
          << turn << ", " << v;
      EXPECT_NEAR(share.at(v), share.at(-v), 1e-6f) << "a knife is symmetric";
    }
  }
}

TEST(EdgeCells, ATipDraggedSidewaysHasNoSidesAtItsEnds) {
  const Tip knife(*builtin_brush("knife"));
  const BristleTable sideways = passed_shares(plan_at(knife, 0, 1.5707963), kSheet);
  EXPECT_NEAR(sideways.at(0.499f), 1, 1e-5f);
  const BristleTable askew = passed_shares(plan_at(knife, 0, 0.7853982), kSheet);
  const BristleTable along = passed_shares(plan_at(knife, 0, 0), kSheet);
  EXPECT_NEAR(1 - askew.at(0.49f), (1 - along.at(0.49f)) / 2, 1e-5f);
  StampPlan tap = plan_at(knife, 0, 0);
  tap.stamp.direction = {0, 0};
  EXPECT_EQ(passed_shares(tap, kSheet).at(0.49f), along.at(0.49f));
}

TEST(EdgeCells, PaintOnAPartOfACellIsAsHighAsItLies) {
  CanvasState canvas = make_canvas_state(kSheet, 1, 1, 3, 0.9f);
  // A film of 1 mm ends in column 20, of which a quarter is covered.
  for (int y = 0; y < kSheet.height; ++y)
    for (int x = 0; x < kSheet.width; ++x) {
      set_base(canvas, x, y, 2e-4f);
      canvas.depth_m(x, y) = x < 20 ? 1e-3f : x == 20 ? 0.25e-3f : 0;
    }
  EXPECT_NEAR(passed_height_m(canvas, 20, 10, 0.25f), 1.2e-3f, 1e-8f);
  EXPECT_NEAR(passed_height_m(canvas, 20, 0, 0.25f), 1.2e-3f, 1e-8f);  // at the canvas's edge
  EXPECT_EQ(passed_height_m(canvas, 10, 10, 0.25f), 1.2e-3f);          // level all around
  EXPECT_EQ(passed_height_m(canvas, 20, 10, 1), 2e-4f + 0.25e-3f);
  // Below: rows instead of columns.
  for (int x = 0; x < kSheet.width; ++x) canvas.depth_m(x, 39) = 0;
  EXPECT_NEAR(passed_height_m(canvas, 5, 38, 0.5f), 2.2e-3f, 1e-8f);
}

}  // namespace
}  // namespace pentimento

#include "core/detail/stamp/queued_stamp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/brush/builtin_brushes.h"

namespace pentimento {
namespace {

// What queued stamps do is tested in tests/core/detail/detail_follower_test.cpp.

/// A slanting flat brush near the canvas's right side, on a guide of 60 x 40 cells of 2 mm.
class QueuedStampTest : public ::testing::Test {
 protected:
  QueuedStampTest() : brush_(builtin_brush("flat")->clone()), tip_(brush_) {
    load_.weight.assign(4, 0.0f);
    load_.paint.assign(4, 0.0f);
    plan_.stamp.x_m = 0.11;
    plan_.stamp.y_m = 0.04;
    plan_.stamp.diameter_m = 0.03f;
    plan_.stamp.twist_rad = 0.5f;
    plan_.stamp.travel_m = 2e-3f;
    plan_.stamp.direction = {0.6f, 0.8f};
    plan_.tip = &tip_;
    plan_.load = &load_;
    plan_.pose = pose_on(guide_.geometry, plan_.stamp, brush_);
    plan_.extent = tip_.extent();
    plan_.box = box_of(plan_.pose, plan_.extent, guide_.geometry);
  }

  const BrushDefinition brush_;
  const Tip tip_;
  PaintLoad load_;
  const CanvasState guide_ = make_canvas_state({60, 40, 0.12, 0.08}, 1, 1, 3, 1.0f);
  StampPlan plan_;
};

TEST_F(QueuedStampTest, TellsWhichBlocksOfARowTheTipReaches) {
  const DetailLayout layout(guide_.geometry, 8);
  const CanvasGeometry fine = layout.fine();
  const std::vector<float> amount(1, 1.0f);
  QueuedStamp stamp(1);
  stamp.draw_tip(plan_, layout);
  stamp.before_deposit(plan_, guide_, layout, amount);
  stamp.find_touched(layout);
  std::vector<float> value(static_cast<std::size_t>(stamp.cells().width));
  int reached = 0, listed = 0;
  for (int y = stamp.blocks().y0; y < stamp.blocks().y1; ++y) {
    const QueuedStamp::BlockSpan span = stamp.touched_blocks(y, layout);
    listed += std::max(0, span.x1 - span.x0);
    EXPECT_GE(span.x0, 0);
    EXPECT_LE(span.x1, 60);
    std::vector<bool> is_reached(60);
    for (int row = y * 8; row < (y + 1) * 8; ++row) {
      stamp.tip().row(tip_row(plan_.pose, stamp.cells(), fine, row), 0, value);
      for (int x = 0; x < stamp.cells().width; ++x)
        if (value[static_cast<std::size_t>(x)] > 0)
          is_reached[static_cast<std::size_t>((stamp.cells().x + x) / 8)] = true;
    }
    for (int x = 0; x < 60; ++x) {
      if (!is_reached[static_cast<std::size_t>(x)]) continue;
      ++reached;
      EXPECT_GE(x, span.x0) << y;
      EXPECT_LT(x, span.x1) << y;
    }
  }
  EXPECT_GT(reached, 20);
  // The flat tip lies askew: a box around it has more than twice as many.
  EXPECT_LT(listed, 3 * reached / 2);
  EXPECT_GT(stamp.blocks().width() * stamp.blocks().height(), 2 * reached);
}

}  // namespace
}  // namespace pentimento

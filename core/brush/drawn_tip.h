#pragma once
// The tip of a stamp as it lies on the cells of the canvas: which of them it touches, and how
// strongly. That follows from the stamp and the brush alone, not from the paint. So the tip of the
// next stamp can be drawn on one thread while another does this stamp.

#include <vector>

#include "core/brush/blade_ends.h"
#include "core/brush/stamp_plan.h"
#include "core/brush/tip_footprint.h"
#include "core/brush/tip_pose.h"
#include "core/brush/touched_cells.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

/// A row of the stamp's box.
struct DrawnTipRow {
  TipRow place;                  // where its cells lie on the tip
  TipFootprint::CellSpan span;   // beyond it the tip is nothing
  TouchedCells touched;          // begin and end alone
  const float* value = nullptr;  // of the tip, in [0,1], in the cells of `span`
};

class DrawnTip {
 public:
  explicit DrawnTip(const CanvasGeometry& grid) : grid_(grid) {}

  /// Draws the tip of a plan that has its place: stamp, tip, pose, extent, box and state.
  /// `is_blade`: its ends are drawn, too.
  void draw(const StampPlan& plan, bool is_blade);
  /// The same without the rows. Then each row must be drawn; different rows may be drawn at the
  /// same time.
  void begin(const StampPlan& plan, bool is_blade);
  void draw_row(int y);

  /// Whether draw() would give what was drawn last, by the brush that it was drawn with.
  bool is_of(const StampPlan& plan) const;
  /// What was drawn is of no use: the brush is another.
  void forget() { tip_ = nullptr; }

  const DrawnTipRow& row(int y) const { return row_[static_cast<std::size_t>(y)]; }
  /// passed_shares() of the plan.
  const BristleTable& passed() const { return passed_; }
  /// The ends of a blade.
  const BladeEnds& ends() const { return ends_; }

 private:
  CanvasGeometry grid_;
  // Of what it was drawn:
  Stamp stamp_;
  const Tip* tip_ = nullptr;  // nullptr: of nothing
  TipState state_;
  TipPose pose_;
  FootprintBox box_;
  // Keeps its memory from stamp to stamp:
  TipFootprint footprint_;
  BristleTable passed_;
  BladeEnds ends_;
  std::vector<float> value_;  // of the cells of the box; only in the spans of rows
  std::vector<DrawnTipRow> row_;
};

}  // namespace pentimento

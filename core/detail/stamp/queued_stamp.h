#pragma once
// A queued stamp: all that the detail canvas needs to do a stamp of the guide later, when the guide
// has gone on.

#include <cstdint>
#include <vector>

#include "core/brush/blade_ends.h"
#include "core/brush/stamp_plan.h"
#include "core/brush/tip_footprint.h"
#include "core/detail/store/block_layers.h"
#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// What the stamp does to the layers of a block.
struct BlockLayers {
  LayerOpening opening;
  bool opens = false;       // the guide opened its cell for the stroke
  std::int8_t target = -1;  // layer that takes the paint; -1: the guide deposits none
};

class QueuedStamp {
 public:
  explicit QueuedStamp(int channels) : reservoir_(channels) {}

  /// Draws the tip as the detail canvas sees it. It may be called beside the next two, and must be
  /// before the tip is asked for.
  void draw_tip(const StampPlan& plan, const DetailLayout& layout);
  /// Copies the plan, and the layers into which the guide is about to deposit. `amount` as in
  /// LayerRow.
  void before_deposit(const StampPlan& plan, const CanvasState& guide, const DetailLayout& layout,
                      std::span<const float> amount);
  /// Copies the reservoir, and notes in which cells the guide deposited.
  void after_deposit(const StampPlan& plan, const CanvasState& guide);
  /// Finds which cells the tip touches. Its tip must have been drawn, and before_deposit() called.
  void find_touched(const DetailLayout& layout);

  const StampPlan& plan() const { return plan_; }
  const TipFootprint& tip() const { return tip_; }
  const BristleTable& grip() const { return grip_; }
  const BladeEnds& ends() const { return ends_; }
  /// False: the stamp only picks up.
  bool deposits() const { return deposits_; }
  /// The fine cells of the tip, and of all blocks that the guide's stamp may touch.
  const FootprintBox& cells() const { return cells_; }
  /// The blocks of those cells.
  const CellBox& blocks() const { return blocks_; }
  /// What the stamp does to the layers of the blocks in row y of the guide, from blocks().x0 on.
  std::span<const BlockLayers> layers_in(int y) const {
    const auto width = static_cast<std::size_t>(blocks_.width());
    return {layers_.data() + static_cast<std::size_t>(y - blocks_.y0) * width, width};
  }
  // After find_touched().
  /// The cells of row y of the fine canvas, counted from cells().x, outside of which the tip is
  /// nothing. `y` is a row of cells().
  TipFootprint::CellSpan touched_cells(int y) const {
    return touched_[static_cast<std::size_t>(y - cells_.y)];
  }
  /// Blocks [x0, x1) of a row of the guide; none where x1 is no more than x0.
  struct BlockSpan {
    int x0 = 0, x1 = 0;
  };
  /// The blocks of row y outside of which the tip is nothing.
  BlockSpan touched_blocks(int y, const DetailLayout& layout) const;
  /// Whether the stamp opens layers in a part of the guide.
  bool opens_in(const CellBox& part) const;

 private:
  StampPlan plan_;
  PaintLoad load_;
  Reservoir reservoir_;
  BristleTable grip_;
  BladeEnds ends_;  // of a blade
  TipFootprint tip_;
  FootprintBox cells_;
  CellBox blocks_;
  std::vector<BlockLayers> layers_;              // per block, row by row
  std::vector<TipFootprint::CellSpan> touched_;  // per row of cells_
  bool deposits_ = false;
};

}  // namespace pentimento

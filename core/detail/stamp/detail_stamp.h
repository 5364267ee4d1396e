#pragma once
// The guide's stamps on the detail canvas. The plans are the same; a few dozen stamps are queued
// and then done tile by tile, while a tile is in the cache. What a stamp does to a cell depends on
// that cell alone, so the order of the cells is free.

#include <memory>
#include <span>
#include <vector>

#include "core/base/threads.h"
#include "core/detail/stamp/queued_stamp.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

class DetailStamp {
 public:
  /// All references must outlive the object; `amount` as in LayerRow.
  DetailStamp(DetailCanvas& canvas, std::span<const float> amount, const Threads& threads);

  /// Makes room for a stamp in the queue, and does those that are in it if it is full.
  void begin();
  /// Draws the tip of the stamp for which there is room now. It may be called beside the next two.
  void draw_tip(const StampPlan& plan) { stamps_[used_ - 1]->draw_tip(plan, canvas_.layout()); }
  /// Queues the stamp. The guide has just picked up paint and not deposited any yet.
  void before_deposit(const StampPlan& plan, const CanvasState& guide);
  /// The guide has deposited. Makes planes for the paint that came.
  void after_deposit(const StampPlan& plan, const CanvasState& guide);
  /// Does all queued stamps.
  void finish();
  /// Drops all queued stamps.
  void forget() { used_ = 0; }
  /// Cells of the guide under the last stamp.
  const CellBox& box() const { return stamps_[used_ - 1]->blocks(); }
  /// Finds which cells the last stamp's tip touches, and adds their blocks. Its tip must have been
  /// drawn.
  void add_touched(ChangedBlocks& blocks);

 private:
  /// The stamps that touch a tile.
  struct TileWork {
    int tile = 0;
    std::vector<int> channels;  // of which the tile has planes
    std::vector<const QueuedStamp*> stamps;
  };
  /// Rows of blocks [y0, y1) of a tile.
  struct RowRange {
    const TileWork* work;
    int y0, y1;
  };
  template <typename Body>
  void for_tiles(const CellBox& blocks, const Body& body) const;
  std::vector<TileWork> list_work() const;
  bool prepare(TileWork& work);
  std::vector<RowRange> list_row_ranges(const std::vector<TileWork>& works) const;

  DetailCanvas& canvas_;
  std::vector<float> amount_;
  const Threads& threads_;
  std::vector<std::unique_ptr<QueuedStamp>> stamps_;  // the first `used_` are queued
  std::size_t used_ = 0;
};

}  // namespace pentimento

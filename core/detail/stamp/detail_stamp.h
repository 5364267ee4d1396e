#pragma once
// The guide's stamps on the detail canvas: the same plans, done a few dozen at a time, tile by
// tile, while a tile's paint is near at hand. What a stamp does to a cell depends on that cell
// alone, so the order of the cells is free.

#include <memory>
#include <span>
#include <vector>

#include "core/base/threads.h"
#include "core/detail/stamp/queued_stamp.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

class DetailStamp {
 public:
  /// All outlive it; `amount` as in LayerRow.
  DetailStamp(DetailCanvas& canvas, std::span<const float> amount, const Threads& threads);

  /// Takes note of a stamp: the guide has just lifted, and not laid yet.
  void before_deposit(const StampPlan& plan, const CanvasState& guide);
  /// The guide has laid. Makes planes for what came.
  void after_deposit(const StampPlan& plan, const CanvasState& guide);
  /// Does all stamps noted since the last time.
  void finish();
  /// Forgets them.
  void forget() { used_ = 0; }
  /// Cells of the guide under the last stamp.
  const CellBox& box() const { return stamps_[used_ - 1]->blocks(); }

 private:
  /// The stamps that touch a tile.
  struct TileWork {
    int tile = 0;
    std::vector<int> channels;  // that the tile has planes of
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
  std::vector<std::unique_ptr<QueuedStamp>> stamps_;  // the first `used_` are waiting
  std::size_t used_ = 0;
};

}  // namespace pentimento

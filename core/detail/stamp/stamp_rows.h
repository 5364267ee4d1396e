#pragma once
// Stamps on some rows of one tile of the detail canvas: the same code per cell as the guide's, with
// the tip and the paper at the fine cells' own resolution. Bands do not touch one another's cells,
// so they may be done side by side.

#include <span>
#include <vector>

#include "core/detail/stamp/queued_stamp.h"
#include "core/detail/store/detail_canvas.h"
#include "core/layers/layer_row.h"

namespace pentimento {

class StampRows {
 public:
  /// `canvas` outlives it; `amount` as in LayerRow.
  StampRows(DetailCanvas& canvas, std::span<const float> amount);

  /// Turns to rows [y0, y1) of blocks of the guide in `tile`, which has its relief, a depth, all
  /// layers of `channels`, and room for openings if a stamp opens layers in it.
  void begin(int tile, const std::vector<int>& channels, int y0, int y1);
  /// Lifts, opens layers in blocks where the guide did as far as the tip touches, lays and mixes.
  void apply(const QueuedStamp& stamp);

 private:
  /// Cells of a row of the band that the tip touches, counted from the tile's first.
  struct CellRange {
    int begin = 0, end = 0;
    bool empty() const { return begin >= end; }
    std::size_t count() const { return static_cast<std::size_t>(end - begin); }
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  LayerRow row(int y, int begin) const;
  void do_row(const QueuedStamp& stamp, int y);
  CellRange measure(const QueuedStamp& stamp, int y);
  void open_blocks(const QueuedStamp& stamp, int block_y);
  void deposit(const QueuedStamp& stamp, int y, const CellRange& touched);
  bool sample(const QueuedStamp& stamp, int y, const CellRange& cells, float* depth);
  bool sample_run(const QueuedStamp& stamp, int y, const CellRange& run, int first, float* depth);
  void open_cells(int y, const CellRange& cells, int first);

  DetailCanvas& canvas_;
  CanvasGeometry fine_;
  std::vector<float> all_amounts_;
  DetailTile* tile_ = nullptr;
  int x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0;       // fine cells of the canvas
  const std::vector<int>* channels_ = nullptr;  // of the tile
  std::vector<float> amount_;                   // of those
  std::vector<float*> planes_;                  // [layer * channels + i]
  // Per cell of a row of the tile.
  std::vector<float> value_, share_, hold_, pick_up_weight_, part_;
  std::vector<float> volume_, height_;  // of the brush's paint there
  std::vector<float> paint_;            // stride floats per cell
};

}  // namespace pentimento

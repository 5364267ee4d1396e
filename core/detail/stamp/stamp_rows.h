#pragma once
// Does stamps on some rows of one tile of the detail canvas. The code for a cell is the guide's,
// with the tip and the paper at the resolution of the fine cells. Row ranges have no cell in
// common, so several threads may work on them.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/detail/stamp/packet_layers.h"
#include "core/detail/stamp/queued_stamp.h"
#include "core/detail/stamp/stamp_packet.h"
#include "core/detail/store/detail_canvas.h"
#include "core/layers/layer_row.h"

namespace pentimento {

class StampRows {
 public:
  /// `canvas` must outlive the object; `amount` as in LayerRow.
  StampRows(DetailCanvas& canvas, std::span<const float> amount);

  /// Turns to the rows [y0, y1) of the guide's blocks in `tile`. The tile must have its relief, its
  /// depth, all layers of `channels`, and tables for open cells if a stamp opens layers in it.
  void begin(int tile, const std::vector<int>& channels, int y0, int y1);
  /// Does one stamp: picks up, opens layers where the guide did and the tip touches, deposits and
  /// mixes.
  void apply(const QueuedStamp& stamp);

 private:
  /// Cells of a row that the tip touches, counted from the tile's first cell.
  struct CellRange {
    int begin = 0, end = 0;
    bool empty() const { return begin >= end; }
    std::size_t count() const { return static_cast<std::size_t>(end - begin); }
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  LayerRow row(int y, int begin) const;
  void do_row(const QueuedStamp& stamp, int y);
  CellRange find_touched(const QueuedStamp& stamp, int y);
  void open_blocks(const QueuedStamp& stamp, int block_y);
  void do_packet(const QueuedStamp& stamp, int y, const StampPacket& packet, int touched);
  void measure(const QueuedStamp& stamp, int y, const StampPacket& packet, int touched);
  void lay(const QueuedStamp& stamp, int y, const StampPacket& packet, float* depth_m);
  bool find_targets(const QueuedStamp& stamp, int y, const StampPacket& packet);
  void open_cells(int y, const StampPacket& packet);

  DetailCanvas& canvas_;
  CanvasGeometry fine_;
  std::vector<float> all_amounts_;
  DetailTile* tile_ = nullptr;
  int x0_ = 0, x1_ = 0, y0_ = 0, y1_ = 0;       // fine cells of the canvas
  const std::vector<int>* channels_ = nullptr;  // of the tile
  std::vector<float> amount_;                   // of these channels
  std::vector<float*> planes_;                  // [layer * channels + i]
  std::vector<float> row_value_;                // of the tip, from the first touched cell on
  PacketLayers layers_;
  // Of a packet's cells.
  PacketValues value_, share_, hold_, pick_up_weight_;
  PacketValues laid_share_, part_, volume_;
  std::array<std::int8_t, kPacketCells> target_;  // layer that gets paint; -1: none does
  std::vector<float> paint_;                      // component after component
  std::vector<const float*> channel_paint_;       // where in it each channel of the tile begins
};

}  // namespace pentimento

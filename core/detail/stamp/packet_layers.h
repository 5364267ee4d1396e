#pragma once
// What a stamp does to the layers of a packet of fine cells. For the packet's own cells it is what
// core/layers does to the cells of a row, with the same bits, but nobody is told what left a cell.
// The other cells of the vectors stay as they are.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/detail/stamp/stamp_packet.h"
#include "core/detail/store/block_layers.h"
#include "core/layers/mix_layers.h"
#include "core/layers/pick_up.h"

namespace pentimento {

class PacketLayers {
 public:
  /// Turns to rows whose planes are `plane` [layer * channels + channel], `cells` values each.
  void begin_rows(std::span<float* const> plane, int cells);
  /// Turns to a packet in them. Cell 0 of `row`, and of all arrays below, is the first cell of the
  /// packet's vectors. Weights and shares are >= 0, and 0 outside of the packet's own cells.
  void begin(const LayerRow& row, const StampPacket& packet);
  const LayerRow& row() const { return row_; }

  /// pick_up_row().
  void pick_up(const PickUp& pick_up, const float* weight, float* depth_m);
  /// Does the opening in the cells where `opens` is not 0.
  void open(const LayerOpening& opening, const float* opens);
  /// plane += part paint, in the layer `target` of each cell; none where that is negative.
  ///   `paint`: per channel, the paint of each cell
  /// Scheme: pointwise. Stability: part, paint >= 0 keep everything >= 0. Source: R25. Departs from
  /// it: nothing.
  void lay(const std::int8_t* target, const float* part, std::span<const float* const> paint);
  /// mix_layers_row().
  void mix(const MixLayers& mix, const float* weight);

 private:
  const LayerRow& held_row();
  void spread_held();

  LayerRow row_;
  StampPacket packet_;
  // Per plane: 0 if the rows, or the packet, are known to hold nothing in it.
  std::vector<std::uint8_t> rows_hold_, held_;
  bool held_is_known_ = false;
};

}  // namespace pentimento

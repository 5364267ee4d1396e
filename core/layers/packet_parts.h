#pragma once
// Which share of its paint a stamp picks up from each layer of a packet's cells (R22, R23).

#include "core/layers/cell_packet.h"
#include "core/layers/pick_up.h"

namespace pentimento {

/// An amount below this is picked up as a whole, before it becomes a subnormal number, which is
/// slow.
inline constexpr float kPickedUpWhole = 1e-20f;

/// Cells [first, first + cells) of a row. Those of a packet are [begin, end), counted from `first`.
struct PacketCells {
  int first = 0, cells = 0;
  int begin = 0, end = 0;
};

/// What leaves each layer of the cells: a share of its paint, f w_k of pick_up_row(), and of the
/// depth.
struct PacketParts {
  std::array<PacketValues, kMaxLayers> layer;
  PacketValues depth;
  int layers = 0;  // that any of the packet's cells has

  /// `weight`: of each cell. False if nothing is picked up anywhere; then the shares are not found.
  bool find(const PickUp& pick_up, const LayerRow& row, const PacketCells& packet,
            const float* weight);
};

}  // namespace pentimento

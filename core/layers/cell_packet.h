#pragma once
// Packets: the kernels of this folder work through a row packet by packet, plane by plane. Planes
// are contiguous along x, so a loop over a packet is a loop over vectors.

#include <algorithm>
#include <array>

#include "core/layers/layer_row.h"

namespace pentimento {

inline constexpr int kPacketCells = 64;
using PacketValues = std::array<float, kPacketCells>;

/// Total amounts (LayerRow::total) of the cells [first, first + count) of a row, per layer.
struct PacketTotals {
  std::array<PacketValues, kMaxLayers> total;
  int count = 0;

  void find(const LayerRow& row, int first, int cells);
  /// Finds how many layers each cell has, empty ones below its top included: LayerRow::top() + 1.
  /// Returns the largest of these numbers.
  int find_occupied(int layers, std::array<int, kPacketCells>& occupied) const;
};

/// Share of the bottom layer that is free: all but the residue (R19). `total`: amount in the layer.
inline float free_share(float total, float residue) {
  return total > residue ? (total - residue) / total : 0.0f;
}

}  // namespace pentimento

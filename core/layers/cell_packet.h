#pragma once
// The kernels of this folder work through a row in packets, plane by plane: planes are contiguous
// along x, so the loops over a packet are loops over vectors.

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
  /// Per cell, one more than its LayerRow::top: how many layers it has, counting empty ones below.
  /// Returns the most.
  int find_occupied(int layers, std::array<int, kPacketCells>& occupied) const;
};

/// Share of the bottom layer that may leave the paper: all but the residue (R19).
inline float free_share(float total, float residue) {
  return total > residue ? (total - residue) / total : 0.0f;
}

}  // namespace pentimento

#pragma once
// The kernels of this folder work through a row in blocks, plane by plane: planes are contiguous
// along x, so the loops over a block are loops over vectors.

#include <algorithm>
#include <array>

#include "core/layers/layer_row.h"

namespace pentimento {

inline constexpr int kBlockCells = 64;
using BlockValues = std::array<float, kBlockCells>;

/// Total amounts (LayerRow::total) of the cells [first, first + count) of a row, per layer.
struct BlockTotals {
  std::array<BlockValues, kMaxLayers> total;
  int count = 0;

  void find(const LayerRow& row, int first, int cells);
  /// Per cell, one more than its LayerRow::top: how many layers it has, counting empty ones below.
  /// Returns the most.
  int find_occupied(int layers, std::array<int, kBlockCells>& occupied) const;
};

/// Share of the bottom layer that may leave the paper: all but the residue (R19).
inline float mobile_share(float total, float residue) {
  return total > residue ? (total - residue) / total : 0.0f;
}

}  // namespace pentimento

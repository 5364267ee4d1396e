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

  void find(const LayerRow& row, int first, int cells) {
    count = cells;
    for (int layer = 0; layer < row.layers; ++layer) {
      BlockValues& sum = total[static_cast<std::size_t>(layer)];
      std::fill_n(sum.begin(), cells, 0.0f);
      for (int c = 0; c < row.channels; ++c) {
        const float m = row.amount[static_cast<std::size_t>(c)];
        if (m == 0) continue;
        const float* plane = &row.at(layer, c, first);
        for (int i = 0; i < cells; ++i) sum[static_cast<std::size_t>(i)] += m * plane[i];
      }
    }
  }
  /// As LayerRow::top of the block's cell i.
  int top(int layers, int i) const {
    for (int layer = layers - 1; layer >= 0; --layer)
      if (total[static_cast<std::size_t>(layer)][static_cast<std::size_t>(i)] > kEmptyLayerAmount)
        return layer;
    return -1;
  }
};

/// Share of the bottom layer that may leave the paper: all but the residue (R19).
inline float mobile_share(float total, float residue) {
  return total > residue ? (total - residue) / total : 0.0f;
}

/// Whether a plane holds anything in a block.
inline bool any_paint(const float* plane, int cells) {
  bool any = false;
  for (int i = 0; i < cells; ++i) any |= plane[i] != 0;
  return any;
}

}  // namespace pentimento

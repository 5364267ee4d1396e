#include "core/layers/lift.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/base/kernel.h"
#include "core/layers/cell_block.h"

namespace pentimento {

namespace {
/// Less than this is lifted whole, before it fades into subnormal numbers, which are slow.
constexpr float kTrace = 1e-20f;

/// Takes share[i] of values[i]; `gone`: what left, exactly.
PENTIMENTO_KERNEL
void take(const float* share, int cells, float* __restrict values, float* __restrict gone) {
  for (int i = 0; i < cells; ++i) {
    const float value = values[i];
    const float rest = value - share[i] * value;
    const float left = rest < kTrace ? 0 : rest;
    gone[i] = value - left;
    values[i] = left;
  }
}

/// Where what is lifted is noted: per cell, `stride` floats apart, and its sums per component.
struct Record {
  float* lifted = nullptr;  // nullptr: nobody asks
  int stride = 0;
  std::span<double> sums;

  /// Adds what left one component, its sum from four interleaved ones.
  void note(const BlockValues& gone, int cells, int first, int component) const {
    if (lifted == nullptr) return;
    float* taken = lifted + static_cast<std::ptrdiff_t>(first) * stride + component;
    double lane[4] = {0, 0, 0, 0};
    for (int i = 0; i < cells; ++i) {
      const float g = gone[static_cast<std::size_t>(i)];
      taken[static_cast<std::ptrdiff_t>(i) * stride] += g;
      lane[i & 3] += static_cast<double>(g);
    }
    sums[static_cast<std::size_t>(component)] += (lane[0] + lane[1]) + (lane[2] + lane[3]);
  }
};

/// A block of cells: where it starts, and the share lifted of each where the brush reaches fully.
struct Block {
  int first = 0, cells = 0;
  BlockValues share;
};

/// The share that leaves a layer of each cell; adds the layer's reach to the weight of the depth.
PENTIMENTO_KERNEL
void find_parts(const Lift& lift, const Block& block, const BlockTotals& totals,
                const std::array<int, kBlockCells>& occupied, int layer,
                float* __restrict depth_weight, float* __restrict part) {
  const float reach_frac = lift.reach_frac, residue = lift.residue;
  for (int i = 0; i < block.cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const bool takes = layer < occupied[at] && block.share[at] > 0;
    const float reach = reach_weight(reach_frac, layer, occupied[at]);
    const float mobile = layer == 0 ? mobile_share(totals.total[0][at], residue) : 1.0f;
    const float weight = reach / static_cast<float>(occupied[at]);
    depth_weight[i] += takes ? weight : 0.0f;
    part[i] = takes ? block.share[at] * reach * mobile : 0.0f;
  }
}

/// Lifts from one layer.
void lift_layer(const Lift& lift, const LayerRow& row, const Block& block,
                const BlockTotals& totals, const std::array<int, kBlockCells>& occupied, int layer,
                BlockValues& depth_weight, const Record& record) {
  BlockValues part{}, gone;
  find_parts(lift, block, totals, occupied, layer, depth_weight.data(), part.data());
  for (int c = 0; c < row.channels; ++c) {
    float* plane = &row.at(layer, c, block.first);
    if (!any_not_zero(plane, block.cells)) continue;
    take(part.data(), block.cells, plane, gone.data());
    record.note(gone, block.cells, block.first, 1 + c);
  }
}

void lift_block(const Lift& lift, const LayerRow& row, const Block& block, float* depth_m,
                const Record& record) {
  BlockTotals totals;
  totals.find(row, block.first, block.cells);
  std::array<int, kBlockCells> occupied;
  const int most = totals.find_occupied(row.layers, occupied);
  BlockValues depth_weight;
  for (int i = 0; i < block.cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    depth_weight[at] = occupied[at] == 0 ? 1.0f : 0.0f;
  }
  for (int layer = 0; layer < most; ++layer)
    lift_layer(lift, row, block, totals, occupied, layer, depth_weight, record);
  for (int i = 0; i < block.cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    depth_weight[at] = block.share[at] * std::min(depth_weight[at], 1.0f);
  }
  BlockValues gone;
  take(depth_weight.data(), block.cells, depth_m, gone.data());
  record.note(gone, block.cells, block.first, 0);
}

void lift_blocks(const Lift& lift, const LayerRow& row, std::span<const float> weight,
                 float* depth_m, const Record& record) {
  const int cells = static_cast<int>(weight.size());
  for (int first = 0; first < cells; first += kBlockCells) {
    Block block;
    block.first = first;
    block.cells = std::min(kBlockCells, cells - first);
    bool any = false;
    for (int i = 0; i < block.cells; ++i) {
      const float share =
          std::min(1.0f, lift.share_frac * weight[static_cast<std::size_t>(first + i)]);
      block.share[static_cast<std::size_t>(i)] = share > 0 ? share : 0;
      any |= share > 0;
    }
    if (any) lift_block(lift, row, block, depth_m + first, record);
  }
}
}  // namespace

float reach_weight(float reach_frac, int layer, int occupied) {
  if (reach_frac < 0) return 1;
  const int from_top = occupied - 1 - layer;
  return std::clamp(reach_frac * static_cast<float>(occupied) - static_cast<float>(from_top), 0.0f,
                    1.0f);
}

void lift_row(const Lift& lift, const LayerRow& row, std::span<const float> weight, float* depth_m,
              float* lifted, int stride, std::span<double> sums) {
  std::fill(sums.begin(), sums.end(), 0.0);
  std::fill_n(lifted, static_cast<std::ptrdiff_t>(weight.size()) * stride, 0.0f);
  lift_blocks(lift, row, weight, depth_m, {lifted, stride, sums});
}

void lift_row(const Lift& lift, const LayerRow& row, std::span<const float> weight,
              float* depth_m) {
  lift_blocks(lift, row, weight, depth_m, {});
}

}  // namespace pentimento

#include "core/layers/deposit.h"

#include <algorithm>
#include <array>

#include "core/layers/cell_packet.h"
#include "core/layers/open_layer.h"

namespace pentimento {

namespace {
bool is_empty(const float* paint, int channels) {
  for (int i = 0; i <= channels; ++i)
    if (paint[i] > 0) return false;
  return true;
}

/// Cells of a packet that take paint, one after the other: where they lie, and in which layer it
/// goes.
struct TakingCells {
  std::array<int, kPacketCells> at;
  std::array<int, kPacketCells> layer;
  int count = 0;
};

/// Finds the cells, opens their layers, and scales down what does not fit.
TakingCells find_cells(const Deposit& deposit, const LayerRow& row, int first, int cells,
                       const float* depth_m, std::uint32_t* stroke, float* paint, int stride) {
  PacketTotals totals;
  totals.find(row, first, cells);
  std::array<int, kPacketCells> occupied;
  totals.find_occupied(row.layers, occupied);
  TakingCells taking;
  for (int i = 0; i < cells; ++i) {
    float* p = paint + static_cast<std::ptrdiff_t>(i) * stride;
    if (is_empty(p, row.channels)) continue;
    const float room_m = std::max(0.0f, deposit.max_depth_m - depth_m[i]);
    if (p[0] > room_m) {
      const float fits = room_m / p[0];
      for (int k = 0; k <= row.channels; ++k) p[k] *= fits;
    }
    const auto n = static_cast<std::size_t>(taking.count++);
    taking.at[n] = i;
    // The same stroke goes on in the top layer, which is known already.
    taking.layer[n] = stroke[i] == deposit.stroke_id
                          ? std::max(0, occupied[static_cast<std::size_t>(i)] - 1)
                          : open_layer(row, first + i, deposit.stroke_id, stroke[i]);
    stroke[i] = deposit.stroke_id;
  }
  return taking;
}

bool any_of_component(const TakingCells& taking, const float* paint, int stride) {
  for (int n = 0; n < taking.count; ++n)
    if (paint[static_cast<std::ptrdiff_t>(taking.at[static_cast<std::size_t>(n)]) * stride] != 0)
      return true;
  return false;
}

/// Adds one component of the paint to a plane, or to one plane for each layer, and returns what
/// they gained. The sum is that of four interleaved sums. Planes that gain nothing are not written
/// to: they may have no memory yet.
template <typename ValueAt>
double give(const TakingCells& taking, const float* paint, int stride, const ValueAt& value_at) {
  if (!any_of_component(taking, paint, stride)) return 0;
  double lane[4] = {0, 0, 0, 0};
  for (int n = 0; n < taking.count; ++n) {
    const auto k = static_cast<std::size_t>(n);
    float& value = value_at(taking.at[k], taking.layer[k]);
    const float after = value + paint[static_cast<std::ptrdiff_t>(taking.at[k]) * stride];
    lane[n & 3] += static_cast<double>(after) - static_cast<double>(value);
    value = after;
  }
  return (lane[0] + lane[1]) + (lane[2] + lane[3]);
}
}  // namespace

void deposit_row(const Deposit& deposit, const LayerRow& row, std::span<float> depth_m,
                 std::uint32_t* stroke, float* paint, int stride, std::span<double> sums) {
  std::fill(sums.begin(), sums.end(), 0.0);
  const int all = static_cast<int>(depth_m.size());
  for (int first = 0; first < all; first += kPacketCells) {
    float* p = paint + static_cast<std::ptrdiff_t>(first) * stride;
    float* depth = depth_m.data() + first;
    const TakingCells taking = find_cells(deposit, row, first, std::min(kPacketCells, all - first),
                                          depth, stroke + first, p, stride);
    if (taking.count == 0) continue;
    sums[0] += give(taking, p, stride, [&](int i, int) -> float& { return depth[i]; });
    for (int c = 0; c < row.channels; ++c) {
      std::array<float*, kMaxLayers> plane;
      for (int layer = 0; layer < row.layers; ++layer)
        plane[static_cast<std::size_t>(layer)] = &row.at(layer, c, first);
      sums[static_cast<std::size_t>(1 + c)] += give(
          taking, p + 1 + c, stride,
          [&](int i, int layer) -> float& { return plane[static_cast<std::size_t>(layer)][i]; });
    }
  }
}

}  // namespace pentimento

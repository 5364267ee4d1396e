#include "core/layers/pick_up.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/base/check.h"
#include "core/base/four.h"
#include "core/base/kernel.h"
#include "core/layers/packet_parts.h"

namespace pentimento {

namespace {
constexpr int kLanes = 4;  // of a sum

/// Takes share[i] of values[i]; `total` grows by what left, exactly. Returns the sum of what left,
/// which is that of four interleaved sums in double. `total` has a whole packet's room: its cells
/// up to the next multiple of four are read and written, too.
PENTIMENTO_KERNEL
double take(const float* share, int cells, float* __restrict values, float* __restrict total) {
  using Doubles = double __attribute__((vector_size(32)));
  PacketValues gone;
  for (int i = 0; i < cells; ++i) {
    const float value = values[i];
    const float rest = value - share[i] * value;
    const float left = rest < kPickedUpWhole ? 0 : rest;
    gone[static_cast<std::size_t>(i)] = value - left;
    values[i] = left;
  }
  for (int i = cells; i % kLanes != 0; ++i) gone[static_cast<std::size_t>(i)] = 0;
  Doubles lanes = {0, 0, 0, 0};
  for (int i = 0; i < cells; i += kLanes) {
    const Four four = four_at(gone.data() + i);
    put_four(four_at(total + i) + four, total + i);
    lanes += __builtin_convertvector(four, Doubles);
  }
  return (lanes[0] + lanes[1]) + (lanes[2] + lanes[3]);
}

/// Components that are written at a time: `stride` is a multiple of it.
constexpr int kTogether = 4;
using Components = std::array<PacketValues, kTogether>;

/// Planes to cells: out[x * stride + k] = component[k][x].
PENTIMENTO_KERNEL
void interleave(const Components& component, int cells, int stride, float* __restrict out) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(cells); ++i, out += stride)
    for (std::size_t k = 0; k < kTogether; ++k) out[k] = component[k][i];
}

/// Where the picked up paint goes: `stride` floats per cell, and the sums of the row.
struct Record {
  float* picked_up = nullptr;
  int stride = 0;
  std::span<double> sums;

  float* at(int cell) const { return picked_up + static_cast<std::ptrdiff_t>(cell) * stride; }
};

/// Takes one component, the height or a pigment of all layers. `gone`: what left each cell. Adds to
/// the sum of the row.
void take_component(const PacketParts& parts, const LayerRow& row, const PacketCells& packet,
                    float* depth_m, int component, PacketValues& gone, double& sum) {
  gone.fill(0);
  if (component == 0) sum += take(parts.depth.data(), packet.cells, depth_m, gone.data());
  for (int layer = 0; component > 0 && layer < parts.layers; ++layer) {
    float* plane = &row.at(layer, component - 1, packet.first);
    if (row.may_hold(layer, component - 1) && any_not_zero(plane, packet.cells))
      sum += take(parts.layer[static_cast<std::size_t>(layer)].data(), packet.cells, plane,
                  gone.data());
  }
}

void take_packet(const PacketParts& parts, const LayerRow& row, const PacketCells& packet,
                 float* depth_m, const Record& record) {
  Components gone;
  for (int first = 0; first <= row.channels; first += kTogether) {
    for (int k = 0; k < kTogether; ++k) {
      PacketValues& here = gone[static_cast<std::size_t>(k)];
      const auto component = static_cast<std::size_t>(first + k);
      if (first + k > row.channels)
        here.fill(0);
      else
        take_component(parts, row, packet, depth_m, first + k, here, record.sums[component]);
    }
    interleave(gone, packet.cells, record.stride, record.at(packet.first) + first);
  }
}
}  // namespace

void pick_up_row(const PickUp& pick_up, const LayerRow& row, std::span<const float> weight,
                 float* depth_m, float* picked_up, int stride, std::span<double> sums) {
  PENTIMENTO_CHECK(stride % kTogether == 0 && stride > row.channels);
  std::fill(sums.begin(), sums.end(), 0.0);
  const Record record{picked_up, stride, sums};
  const int cells = static_cast<int>(weight.size());
  for (int first = 0; first < cells; first += kPacketCells) {
    const int here = std::min(kPacketCells, cells - first);
    const PacketCells packet{first, here, 0, here};
    PacketParts parts;
    if (parts.find(pick_up, row, packet, weight.data() + first))
      take_packet(parts, row, packet, depth_m + first, record);
    else
      std::fill_n(record.at(first), here * stride, 0.0f);
  }
}

}  // namespace pentimento

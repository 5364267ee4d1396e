#include "core/layers/pick_up.h"

#include <algorithm>
#include <cstring>

#include "core/base/any_not_zero.h"
#include "core/base/check.h"
#include "core/base/kernel.h"
#include "core/layers/cell_packet.h"

namespace pentimento {

namespace {
/// An amount below this is picked up as a whole, before it becomes a subnormal number, which is
/// slow.
constexpr float kTrace = 1e-20f;
constexpr int kLanes = 4;  // of a sum

/// Takes share[i] of values[i]; `total` grows by what left, exactly. Returns the sum of what left,
/// which is that of four interleaved sums in double. `total` has a whole packet's room: its cells
/// up to the next multiple of four are read and written, too.
PENTIMENTO_KERNEL
double take(const float* share, int cells, float* __restrict values, float* __restrict total) {
  using Doubles = double __attribute__((vector_size(32)));
  using Floats = float __attribute__((vector_size(16)));
  PacketValues gone;
  for (int i = 0; i < cells; ++i) {
    const float value = values[i];
    const float rest = value - share[i] * value;
    const float left = rest < kTrace ? 0 : rest;
    gone[static_cast<std::size_t>(i)] = value - left;
    values[i] = left;
  }
  for (int i = cells; i % kLanes != 0; ++i) gone[static_cast<std::size_t>(i)] = 0;
  Doubles lanes = {0, 0, 0, 0};
  for (int i = 0; i < cells; i += kLanes) {
    Floats four, sum;
    std::memcpy(&four, gone.data() + i, sizeof(four));
    std::memcpy(&sum, total + i, sizeof(sum));
    sum += four;
    std::memcpy(total + i, &sum, sizeof(sum));
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

/// A packet of cells: where it starts, and the share that is picked up of each cell where the
/// bristles reach fully.
struct Packet {
  int first = 0, cells = 0;
  PacketValues share;
};

/// The share that leaves a layer of each cell; adds the layer's reach to the weight of the depth.
PENTIMENTO_KERNEL
void find_parts(const PickUp& pick_up, const Packet& packet, const PacketTotals& totals,
                const std::array<int, kPacketCells>& occupied, int layer,
                float* __restrict depth_weight, float* __restrict part) {
  const float penetration_frac = pick_up.penetration_frac, residue = pick_up.residue;
  for (int i = 0; i < packet.cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const bool takes = layer < occupied[at] && packet.share[at] > 0;
    const float reach = penetration_weight(penetration_frac, layer, occupied[at]);
    const float mobile = layer == 0 ? free_share(totals.total[0][at], residue) : 1.0f;
    const float weight = reach / static_cast<float>(occupied[at]);
    depth_weight[i] += takes ? weight : 0.0f;
    part[i] = takes ? packet.share[at] * reach * mobile : 0.0f;
  }
}

/// What leaves each layer of a packet's cells: a share of its paint, and of the depth.
struct PacketParts {
  std::array<PacketValues, kMaxLayers> layer;
  PacketValues depth;
  int layers = 0;  // that any of the cells has

  void find(const PickUp& pick_up, const LayerRow& row, const Packet& packet) {
    PacketTotals totals;
    totals.find(row, packet.first, packet.cells);
    std::array<int, kPacketCells> occupied;
    layers = totals.find_occupied(row.layers, occupied);
    for (int i = 0; i < packet.cells; ++i) {
      const std::size_t at = static_cast<std::size_t>(i);
      depth[at] = occupied[at] == 0 ? 1.0f : 0.0f;
    }
    for (int k = 0; k < layers; ++k)
      find_parts(pick_up, packet, totals, occupied, k, depth.data(),
                 layer[static_cast<std::size_t>(k)].data());
    for (int i = 0; i < packet.cells; ++i) {
      const std::size_t at = static_cast<std::size_t>(i);
      depth[at] = packet.share[at] * std::min(depth[at], 1.0f);
    }
  }
};

/// Takes one component, the height or a pigment of all layers. `gone`: what left each cell. Adds to
/// the sum of the row.
void take_component(const PacketParts& parts, const LayerRow& row, const Packet& packet,
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

void pick_up_packet(const PickUp& pick_up, const LayerRow& row, const Packet& packet,
                    float* depth_m, const Record& record) {
  PacketParts parts;
  parts.find(pick_up, row, packet);
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

void pick_up_packets(const PickUp& pick_up, const LayerRow& row, std::span<const float> weight,
                     float* depth_m, const Record& record) {
  const int cells = static_cast<int>(weight.size());
  for (int first = 0; first < cells; first += kPacketCells) {
    Packet packet;
    packet.first = first;
    packet.cells = std::min(kPacketCells, cells - first);
    bool any = false;
    for (int i = 0; i < packet.cells; ++i) {
      const float share =
          std::min(1.0f, pick_up.share_frac * weight[static_cast<std::size_t>(first + i)]);
      packet.share[static_cast<std::size_t>(i)] = share > 0 ? share : 0;
      any |= share > 0;
    }
    if (any)
      pick_up_packet(pick_up, row, packet, depth_m + first, record);
    else
      std::fill_n(record.at(first), packet.cells * record.stride, 0.0f);
  }
}
}  // namespace

void pick_up_row(const PickUp& pick_up, const LayerRow& row, std::span<const float> weight,
                 float* depth_m, float* picked_up, int stride, std::span<double> sums) {
  PENTIMENTO_CHECK(stride % kTogether == 0 && stride > row.channels);
  std::fill(sums.begin(), sums.end(), 0.0);
  pick_up_packets(pick_up, row, weight, depth_m, {picked_up, stride, sums});
}

}  // namespace pentimento

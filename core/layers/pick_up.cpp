#include "core/layers/pick_up.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/base/kernel.h"
#include "core/layers/cell_packet.h"

namespace pentimento {

namespace {
/// An amount below this is picked up as a whole, before it becomes a subnormal number, which is
/// slow.
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

/// Where the picked up paint goes: one component per cell, `stride` floats apart, and its sum.
struct Record {
  float* picked_up = nullptr;  // nullptr: nobody asks
  int stride = 0;
  std::span<double> sums;

  /// Adds the paint that left one component. The sum is that of four interleaved sums.
  void note(const PacketValues& gone, int cells, int first, int component) const {
    if (picked_up == nullptr) return;
    float* taken = picked_up + static_cast<std::ptrdiff_t>(first) * stride + component;
    double lane[4] = {0, 0, 0, 0};
    for (int i = 0; i < cells; ++i) {
      const float g = gone[static_cast<std::size_t>(i)];
      taken[static_cast<std::ptrdiff_t>(i) * stride] += g;
      lane[i & 3] += static_cast<double>(g);
    }
    sums[static_cast<std::size_t>(component)] += (lane[0] + lane[1]) + (lane[2] + lane[3]);
  }
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

/// Picks up from one layer.
void pick_up_layer(const PickUp& pick_up, const LayerRow& row, const Packet& packet,
                   const PacketTotals& totals, const std::array<int, kPacketCells>& occupied,
                   int layer, PacketValues& depth_weight, const Record& record) {
  PacketValues part{}, gone;
  find_parts(pick_up, packet, totals, occupied, layer, depth_weight.data(), part.data());
  for (int c = 0; c < row.channels; ++c) {
    float* plane = &row.at(layer, c, packet.first);
    if (!any_not_zero(plane, packet.cells)) continue;
    take(part.data(), packet.cells, plane, gone.data());
    record.note(gone, packet.cells, packet.first, 1 + c);
  }
}

void pick_up_packet(const PickUp& pick_up, const LayerRow& row, const Packet& packet,
                    float* depth_m, const Record& record) {
  PacketTotals totals;
  totals.find(row, packet.first, packet.cells);
  std::array<int, kPacketCells> occupied;
  const int most = totals.find_occupied(row.layers, occupied);
  PacketValues depth_weight;
  for (int i = 0; i < packet.cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    depth_weight[at] = occupied[at] == 0 ? 1.0f : 0.0f;
  }
  for (int layer = 0; layer < most; ++layer)
    pick_up_layer(pick_up, row, packet, totals, occupied, layer, depth_weight, record);
  for (int i = 0; i < packet.cells; ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    depth_weight[at] = packet.share[at] * std::min(depth_weight[at], 1.0f);
  }
  PacketValues gone;
  take(depth_weight.data(), packet.cells, depth_m, gone.data());
  record.note(gone, packet.cells, packet.first, 0);
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
    if (any) pick_up_packet(pick_up, row, packet, depth_m + first, record);
  }
}
}  // namespace

float penetration_weight(float penetration_frac, int layer, int occupied) {
  if (penetration_frac < 0) return 1;
  const int from_top = occupied - 1 - layer;
  return std::clamp(penetration_frac * static_cast<float>(occupied) - static_cast<float>(from_top),
                    0.0f, 1.0f);
}

void pick_up_row(const PickUp& pick_up, const LayerRow& row, std::span<const float> weight,
                 float* depth_m, float* picked_up, int stride, std::span<double> sums) {
  std::fill(sums.begin(), sums.end(), 0.0);
  std::fill_n(picked_up, static_cast<std::ptrdiff_t>(weight.size()) * stride, 0.0f);
  pick_up_packets(pick_up, row, weight, depth_m, {picked_up, stride, sums});
}

void pick_up_row(const PickUp& pick_up, const LayerRow& row, std::span<const float> weight,
                 float* depth_m) {
  pick_up_packets(pick_up, row, weight, depth_m, {});
}

}  // namespace pentimento

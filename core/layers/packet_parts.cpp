#include "core/layers/packet_parts.h"

#include <algorithm>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
/// min(1, share_frac weight). False if it is 0 everywhere.
PENTIMENTO_KERNEL
bool find_shares(float share_frac, const float* weight, int cells, float* __restrict share) {
  int any = 0;  // not a bool, which keeps the loop from being a vector's
  for (int i = 0; i < cells; ++i) {
    const float wanted = std::min(1.0f, share_frac * weight[i]);
    share[i] = wanted > 0 ? wanted : 0.0f;
    any |= wanted > 0 ? 1 : 0;
  }
  return any != 0;
}

/// The share that leaves a layer of each cell; adds the layer's reach to the weight of the depth.
/// `bottom`: amount in the bottom layer.
PENTIMENTO_KERNEL
void find_layer(const PickUp& pick_up, const float* bottom, const int* occupied, int layer,
                const float* share, int cells, float* __restrict depth_weight,
                float* __restrict part) {
  const float penetration_frac = pick_up.penetration_frac, residue = pick_up.residue;
  for (int i = 0; i < cells; ++i) {
    const float reach = penetration_weight(penetration_frac, layer, occupied[i]);
    const float mobile = layer == 0 ? free_share(bottom[i], residue) : 1.0f;
    const float weight = reach / static_cast<float>(occupied[i]);
    const float taken = share[i] * reach * mobile;
    // No &&, which keeps the loop from being a vector's.
    const bool takes = (layer < occupied[i]) & (share[i] > 0);
    depth_weight[i] += takes ? weight : 0.0f;
    part[i] = takes ? taken : 0.0f;
  }
}

/// 1 in cells of no layer, whose depth is taken as it is.
PENTIMENTO_KERNEL
void begin_depth(const int* occupied, int cells, float* __restrict weight) {
  for (int i = 0; i < cells; ++i) weight[i] = occupied[i] == 0 ? 1.0f : 0.0f;
}

PENTIMENTO_KERNEL
void end_depth(const float* share, int cells, float* __restrict weight) {
  for (int i = 0; i < cells; ++i) weight[i] = share[i] * std::min(weight[i], 1.0f);
}
}  // namespace

bool PacketParts::find(const PickUp& pick_up, const LayerRow& row, const PacketCells& packet,
                       const float* weight) {
  const int cells = packet.cells;
  PacketValues share;
  if (!find_shares(pick_up.share_frac, weight, cells, share.data())) return false;
  PacketTotals totals;
  totals.find(row, packet.first, cells);
  std::array<int, kPacketCells> occupied;
  totals.find_occupied(row.layers, occupied);
  layers = *std::max_element(occupied.begin() + packet.begin, occupied.begin() + packet.end);
  begin_depth(occupied.data(), cells, depth.data());
  for (int k = 0; k < layers; ++k)
    find_layer(pick_up, totals.total[0].data(), occupied.data(), k, share.data(), cells,
               depth.data(), layer[static_cast<std::size_t>(k)].data());
  end_depth(share.data(), cells, depth.data());
  return true;
}

}  // namespace pentimento

#include "core/detail/stamp/packet_layers.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/base/kernel.h"

namespace pentimento {

namespace {
/// LayerRow::total() of each cell.
PENTIMENTO_KERNEL
void add_channels(const LayerRow& row, int layer, const std::uint8_t* held, int n,
                  float* __restrict total) {
  for (int i = 0; i < n; ++i) total[i] = 0;
  for (int c = 0; c < row.channels; ++c) {
    const float m = row.amount[static_cast<std::size_t>(c)];
    if (held[c] == 0 || m == 0) continue;
    const float* plane = &row.at(layer, c, 0);
    for (int i = 0; i < n; ++i) total[i] += m * plane[i];
  }
}

PENTIMENTO_KERNEL
void raise_levels(const float* total, int n, int levels, int* __restrict occupied) {
  for (int i = 0; i < n; ++i) occupied[i] = total[i] > kEmptyLayerAmount ? levels : occupied[i];
}

PENTIMENTO_KERNEL
int highest(const int* values, int n) {
  int most = 0;
  for (int i = 0; i < n; ++i) most = std::max(most, values[i]);
  return most;
}

/// min(1, share_frac weight). False if it is 0 everywhere.
PENTIMENTO_KERNEL
bool find_shares(float share_frac, const float* weight, int n, float* __restrict share) {
  int any = 0;  // not a bool, which keeps the loop from being a vector's
  for (int i = 0; i < n; ++i) {
    const float wanted = std::min(1.0f, share_frac * weight[i]);
    share[i] = wanted > 0 ? wanted : 0.0f;
    any |= wanted > 0 ? 1 : 0;
  }
  return any != 0;
}

/// The share that leaves a layer of each cell; adds the layer's reach to the weight of the depth.
/// `bottom`: amount in the bottom layer.
PENTIMENTO_KERNEL
void find_layer_parts(const PickUp& pick_up, const float* bottom, const int* occupied, int layer,
                      const float* share, int n, float* __restrict depth_weight,
                      float* __restrict part) {
  const float penetration_frac = pick_up.penetration_frac, residue = pick_up.residue;
  for (int i = 0; i < n; ++i) {
    const float reach = penetration_weight(penetration_frac, layer, occupied[i]);
    const float mobile = layer == 0 ? free_share(bottom[i], residue) : 1.0f;
    const float weight = reach / static_cast<float>(occupied[i]);
    const float taken = share[i] * reach * mobile;
    const bool takes = (layer < occupied[i]) & (share[i] > 0);
    depth_weight[i] += takes ? weight : 0.0f;
    part[i] = takes ? taken : 0.0f;
  }
}

/// An amount below `trace` is taken as a whole, before it becomes a subnormal number, which is
/// slow.
PENTIMENTO_KERNEL
void take_parts(const float* part, const float* trace, int n, float* __restrict values) {
  for (int i = 0; i < n; ++i) {
    const float rest = values[i] - part[i] * values[i];
    values[i] = rest < trace[i] ? 0.0f : rest;
  }
}

/// Takes a part of each channel of a layer that is `held`.
PENTIMENTO_KERNEL
void take_channels(const LayerRow& row, int layer, const std::uint8_t* held, const float* part,
                   const float* trace, int n) {
  for (int c = 0; c < row.channels; ++c) {
    if (held[c] == 0) continue;
    float* __restrict plane = &row.at(layer, c, 0);
    for (int i = 0; i < n; ++i) {
      const float rest = plane[i] - part[i] * plane[i];
      plane[i] = rest < trace[i] ? 0.0f : rest;
    }
  }
}

/// 1 in cells of no layer, whose depth is taken as it is.
PENTIMENTO_KERNEL
void begin_depth_weight(const int* occupied, int n, float* __restrict weight) {
  for (int i = 0; i < n; ++i) weight[i] = occupied[i] == 0 ? 1.0f : 0.0f;
}

PENTIMENTO_KERNEL
void end_depth_weight(const float* share, int n, float* __restrict weight) {
  for (int i = 0; i < n; ++i) weight[i] = share[i] * std::min(weight[i], 1.0f);
}

/// Where a cell `opens`, adds a layer to another and empties it.
PENTIMENTO_KERNEL
void move_layer(const LayerRow& row, int from, int to, const float* opens, int n) {
  for (int c = 0; c < row.channels; ++c) {
    float* lower = &row.at(to, c, 0);
    float* upper = &row.at(from, c, 0);
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < n; ++i) {
      const float moved = lower[i] + upper[i];
      lower[i] = opens[i] != 0 ? moved : lower[i];
      upper[i] = opens[i] != 0 ? 0.0f : upper[i];
    }
  }
}

/// The part of the cells whose target is `layer`, else 0.
PENTIMENTO_KERNEL
void select_parts(const std::int8_t* target, const float* part, int layer, int n,
                  float* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = target[i] == layer ? part[i] : 0.0f;
}

PENTIMENTO_KERNEL
void add_product(const float* part, const float* paint, int n, float* __restrict plane) {
  for (int i = 0; i < n; ++i) plane[i] += part[i] * paint[i];
}

/// What may be exchanged between layer k and the next one of each cell: m below its topmost layer.
/// False if it is 0 everywhere.
PENTIMENTO_KERNEL
bool find_exchange_row(const MixLayers& mix, const float* weight, const int* occupied, int k, int n,
                       float* __restrict exchange) {
  const float frac = mix.exchange_frac;
  int any = 0;
  for (int i = 0; i < n; ++i) {
    const float m = std::max(0.0f, std::min(0.5f, frac * weight[i]));
    exchange[i] = k + 1 < occupied[i] ? m : 0.0f;
    any |= exchange[i] != 0 ? 1 : 0;
  }
  return any != 0;
}

PENTIMENTO_KERNEL
void find_mobile(const float* bottom, float residue, int n, float* __restrict mobile) {
  for (int i = 0; i < n; ++i) mobile[i] = free_share(bottom[i], residue);
}

/// Exchange between the layers of one channel; `most`: layers of the highest cell.
PENTIMENTO_KERNEL
void exchange_channel(const LayerRow& row, int channel, const PacketValues& mobile,
                      const std::array<PacketValues, kMaxLayers>& exchange, int most, int n) {
  PacketValues below, incoming;
  float* __restrict under = below.data();
  float* __restrict in = incoming.data();
  const float* bottom = &row.at(0, channel, 0);
  for (int i = 0; i < n; ++i) {
    under[i] = mobile[static_cast<std::size_t>(i)] * bottom[i];
    in[i] = 0;
  }
  for (int k = 0; k + 1 < most; ++k) {
    float* lower = &row.at(k, channel, 0);
    const float* upper = &row.at(k + 1, channel, 0);
    const float* share = exchange[static_cast<std::size_t>(k)].data();
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < n; ++i) {
      const float outgoing = share[i] * (under[i] - upper[i]);
      lower[i] += in[i] - outgoing;
      in[i] = outgoing;
      under[i] = upper[i];
    }
  }
  float* top = &row.at(most - 1, channel, 0);
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) top[i] += in[i];
}
}  // namespace

void PacketLayers::begin_rows(std::span<float* const> plane, int cells) {
  constexpr int kTogether = 1024;
  const auto holds = [&](const float* values) {
    for (int i = 0; i < cells; i += kTogether)
      if (any_not_zero(values + i, std::min(kTogether, cells - i))) return true;
    return false;
  };
  rows_hold_.clear();
  for (const float* values : plane) rows_hold_.push_back(holds(values) ? 1 : 0);
}

void PacketLayers::begin(const LayerRow& row, const StampPacket& packet) {
  row_ = row;
  packet_ = packet;
  PENTIMENTO_CHECK(rows_hold_.size() == static_cast<std::size_t>(row.layers * row.channels));
  held_.resize(rows_hold_.size());
  held_is_known_ = false;
}

void PacketLayers::find_held() {
  for (std::size_t p = 0; p < held_.size(); ++p)
    held_[p] =
        rows_hold_[p] != 0 && any_not_zero(row_.plane[p] + row_.offset, packet_.cells) ? 1 : 0;
  held_is_known_ = true;
}

void PacketLayers::measure() {
  if (!held_is_known_) find_held();
  occupied_.fill(0);
  for (int layer = 0; layer < row_.layers; ++layer) {
    float* total = total_[static_cast<std::size_t>(layer)].data();
    add_channels(row_, layer, held_in(layer), packet_.cells, total);
    raise_levels(total, packet_.cells, layer + 1, occupied_.data());
  }
  std::fill_n(occupied_.begin(), packet_.begin, 0);
  std::fill(occupied_.begin() + packet_.end, occupied_.begin() + packet_.cells, 0);
  most_ = highest(occupied_.data(), packet_.cells);
}

void PacketLayers::pick_up(const PickUp& pick_up, const float* weight, float* depth_m) {
  constexpr float kTrace = 1e-20f;
  const int n = packet_.cells;
  PacketValues share, part, depth_part, trace;
  if (!find_shares(pick_up.share_frac, weight, n, share.data())) return;
  std::fill_n(trace.begin(), packet_.size(), 0.0f);
  std::fill(trace.begin() + packet_.begin, trace.begin() + packet_.end, kTrace);
  measure();
  // The pigment of each layer, as far as the bristles reach it; then the depth by their mean reach.
  begin_depth_weight(occupied_.data(), n, depth_part.data());
  for (int layer = 0; layer < most_; ++layer) {
    find_layer_parts(pick_up, total_[0].data(), occupied_.data(), layer, share.data(), n,
                     depth_part.data(), part.data());
    take_channels(row_, layer, held_in(layer), part.data(), trace.data(), n);
  }
  end_depth_weight(share.data(), n, depth_part.data());
  take_parts(depth_part.data(), trace.data(), n, depth_m);
}

/// Any layer may get what the rows hold of a channel.
void PacketLayers::spread_held() {
  const auto channels = static_cast<std::size_t>(row_.channels);
  for (std::size_t c = 0; c < channels; ++c) {
    std::uint8_t any = 0;
    for (std::size_t p = c; p < rows_hold_.size(); p += channels) any |= rows_hold_[p];
    for (std::size_t p = c; p < rows_hold_.size(); p += channels) rows_hold_[p] = any;
  }
}

void PacketLayers::open(const LayerOpening& opening, const float* opens) {
  const int n = packet_.cells;
  held_is_known_ = false;
  spread_held();
  for (int layer = 0; layer < row_.layers; ++layer) {
    const int to = opening.to[static_cast<std::size_t>(layer)];
    if (to != layer) move_layer(row_, layer, to, opens, n);
  }
  // The bottom two layers become one, and those above move down into the empty ones.
  for (int layer = 1; opening.merges && layer < row_.layers; ++layer)
    move_layer(row_, layer, layer - 1, opens, n);
}

void PacketLayers::lay(const std::int8_t* target, const float* part,
                       std::span<const float* const> paint) {
  const int n = packet_.cells;
  std::array<bool, kMaxLayers> takes{};
  for (int i = packet_.begin; i < packet_.end; ++i)
    if (target[i] >= 0) takes[static_cast<std::size_t>(target[i])] = true;
  for (int layer = 0; layer < row_.layers; ++layer) {
    if (!takes[static_cast<std::size_t>(layer)]) continue;
    PacketValues here;
    select_parts(target, part, layer, n, here.data());
    for (int c = 0; c < row_.channels; ++c) {
      const float* from = paint[static_cast<std::size_t>(c)];
      if (!any_not_zero(from, n)) continue;
      add_product(here.data(), from, n, &row_.at(layer, c, 0));
      held_in(layer)[c] = 1;
      rows_hold_[static_cast<std::size_t>(layer * row_.channels + c)] = 1;
    }
  }
}

bool PacketLayers::holds_channel(int channel) {
  for (int layer = 0; layer < row_.layers; ++layer)
    if (held_in(layer)[channel] != 0) return true;
  return false;
}

void PacketLayers::mix(const MixLayers& mix, const float* weight) {
  if (row_.layers < 2 || !(mix.exchange_frac > 0)) return;
  const int n = packet_.cells;
  measure();
  if (most_ < 2) return;
  PacketValues mobile;
  std::array<PacketValues, kMaxLayers> exchange;
  for (int k = 0; k + 1 < most_; ++k) {
    float* share = exchange[static_cast<std::size_t>(k)].data();
    const bool any = find_exchange_row(mix, weight, occupied_.data(), k, n, share);
    if (k == 0 && !any) return;
  }
  find_mobile(total_[0].data(), mix.residue, n, mobile.data());
  for (int c = 0; c < row_.channels; ++c)
    if (holds_channel(c)) exchange_channel(row_, c, mobile, exchange, most_, n);
  spread_held();
}

}  // namespace pentimento

#include "core/detail/stamp/packet_layers.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/base/kernel.h"
#include "core/layers/packet_parts.h"

namespace pentimento {

namespace {
/// What is below `whole` is taken as a whole.
PENTIMENTO_KERNEL
void take_parts(const float* part, const float* whole, int n, float* __restrict values) {
  for (int i = 0; i < n; ++i) {
    const float rest = values[i] - part[i] * values[i];
    values[i] = rest < whole[i] ? 0.0f : rest;
  }
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

/// The row, with notes which planes the packet's cells may hold anything in.
const LayerRow& PacketLayers::held_row() {
  if (!held_is_known_)
    for (std::size_t p = 0; p < held_.size(); ++p)
      held_[p] =
          rows_hold_[p] != 0 && any_not_zero(row_.plane[p] + row_.offset, packet_.cells) ? 1 : 0;
  held_is_known_ = true;
  row_.holds = held_;
  return row_;
}

void PacketLayers::pick_up(const PickUp& pick_up, const float* weight, float* depth_m) {
  PacketParts parts;
  const PacketCells cells{0, packet_.cells, packet_.begin, packet_.end};
  if (!parts.find(pick_up, held_row(), cells, weight)) return;
  PacketValues whole;
  std::fill_n(whole.begin(), packet_.size(), 0.0f);
  std::fill(whole.begin() + packet_.begin, whole.begin() + packet_.end, kPickedUpWhole);
  for (int layer = 0; layer < parts.layers; ++layer)
    for (int c = 0; c < row_.channels; ++c)
      if (row_.may_hold(layer, c))
        take_parts(parts.layer[static_cast<std::size_t>(layer)].data(), whole.data(), packet_.cells,
                   &row_.at(layer, c, 0));
  take_parts(parts.depth.data(), whole.data(), packet_.cells, depth_m);
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
      const auto plane = static_cast<std::size_t>(layer * row_.channels + c);
      held_[plane] = rows_hold_[plane] = 1;
    }
  }
}

void PacketLayers::mix(const MixLayers& mix, const float* weight) {
  mix_layers_row(mix, held_row(), {weight, packet_.size()});
  held_is_known_ = false;
  spread_held();
}

}  // namespace pentimento

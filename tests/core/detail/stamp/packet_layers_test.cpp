#include "core/detail/stamp/packet_layers.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "core/layers/open_layer.h"

namespace pentimento {
namespace {

/// A row of a tile: planes with gaps, layers that end at different cells, and traces.
struct TileRow {
  TileRow(int layers, int channels, int side, unsigned seed)
      : depth_m(static_cast<std::size_t>(side)), layers(layers), channels(channels) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> some(0, 1);
    for (float& depth : depth_m) depth = 1e-3f * some(random);
    for (int p = 0; p < layers * channels; ++p) {
      std::vector<float>& plane = planes.emplace_back(static_cast<std::size_t>(side), 0.0f);
      if (p % 5 == 3) continue;  // holds nothing
      const float from = some(random) - 0.6f, to = from + 2 * some(random);
      for (std::size_t x = 0; x < plane.size(); ++x) {
        const float at = static_cast<float>(x) / static_cast<float>(side);
        if (at >= from && at < to) plane[x] = x % 7 == 3 ? 1e-21f : some(random);
      }
    }
    for (int c = 0; c < channels; ++c) amount.push_back(c == 1 ? 0.0f : 1.0f);
  }

  LayerRow row(int first) {
    pointers.clear();
    for (std::vector<float>& plane : planes) pointers.push_back(plane.data());
    return {pointers, first, layers, channels, amount, {}};
  }
  bool operator==(const TileRow& other) const {
    return planes == other.planes && depth_m == other.depth_m;
  }

  std::vector<std::vector<float>> planes;
  std::vector<float> depth_m, amount;
  std::vector<float*> pointers;
  int layers, channels;
};

void pick_up_plainly(const PickUp& pick_up, TileRow& row, int x, std::span<const float> weight) {
  const int stride = (row.channels + 4) / 4 * 4;
  std::vector<float> gone(weight.size() * static_cast<std::size_t>(stride));
  std::vector<double> sums(static_cast<std::size_t>(row.channels) + 1);
  pick_up_row(pick_up, row.row(x), weight, row.depth_m.data() + x, gone.data(), stride, sums);
}

/// What is done to a packet, with weights for its vectors, and the same plainly for its own cells.
struct Twins {
  std::function<void(PacketLayers&, const StampPacket&, float* depth_m, const float* weight)> fast;
  std::function<void(TileRow&, int x, std::span<const float> weight)> plain;
};

/// Both on rows of many shapes, for packets of many sizes and places. They must agree in every bit
/// of the whole row.
void expect_same(const Twins& twins) {
  unsigned seed = 1;
  for (const int side : {128, 126, 119, 96}) {
    for (const auto& [layers, channels] : {std::pair{1, 2}, {2, 3}, {4, 5}, {8, 1}}) {
      for (const auto& [x, own] :
           {std::pair{0, 64}, {0, 1}, {9, 25}, {side - 1, 1}, {side - 64, 64}, {side - 17, 17}}) {
        TileRow fast(layers, channels, side, ++seed);
        TileRow plain = fast;
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> some(-0.3f, 2);
        std::vector<float> weight;
        for (int i = 0; i < own; ++i) weight.push_back(std::max(0.0f, some(random)));
        const StampPacket packet = packet_at(x, own, side);
        PacketValues wide{};
        std::copy(weight.begin(), weight.end(), wide.begin() + packet.begin);
        PacketLayers layers_of;
        layers_of.begin_rows(fast.row(0).plane, side);
        layers_of.begin(fast.row(packet.first), packet);
        twins.fast(layers_of, packet, fast.depth_m.data() + packet.first, wide.data());
        twins.plain(plain, x, weight);
        ASSERT_TRUE(fast == plain)
            << side << " cells, " << layers << " layers, " << own << " from " << x;
      }
    }
  }
}

TEST(PacketLayers, PickUpIsThatOfARow) {
  for (const float penetration_frac : {-1.0f, 0.4f, 1.0f}) {
    const PickUp pick_up{0.7f, penetration_frac, 0.2f};
    expect_same({[&](PacketLayers& layers, const StampPacket&, float* depth_m,
                     const float* weight) { layers.pick_up(pick_up, weight, depth_m); },
                 [&](TileRow& row, int x, std::span<const float> weight) {
                   pick_up_plainly(pick_up, row, x, weight);
                 }});
  }
}

TEST(PacketLayers, MixingIsThatOfARow) {
  const MixLayers mix{0.4f, 0.2f};
  expect_same({[&](PacketLayers& layers, const StampPacket&, float*, const float* weight) {
                 layers.mix(mix, weight);
               },
               [&](TileRow& row, int x, std::span<const float> weight) {
                 mix_layers_row(mix, row.row(x), weight);
               }});
}

/// The opening in one cell.
void open_plainly(const LayerOpening& opening, const LayerRow& row, int x) {
  for (int layer = 0; layer < row.layers; ++layer) {
    const int to = opening.to[static_cast<std::size_t>(layer)];
    if (to == layer) continue;
    for (int c = 0; c < row.channels; ++c) {
      row.at(to, c, x) += row.at(layer, c, x);
      row.at(layer, c, x) = 0;
    }
  }
  if (opening.merges) merge_bottom_layers(row, x);
}

/// Full layers, and layers of which the bottom one is empty.
std::vector<LayerOpening> openings(int layers) {
  std::vector<float> total(static_cast<std::size_t>(layers), 1.0f);
  const LayerOpening full = opening_of(total);
  total[0] = 0;
  return {full, opening_of(total)};
}

TEST(PacketLayers, OpeningIsThatOfEachCell) {
  for (const std::size_t which : {0u, 1u})
    expect_same({[&](PacketLayers& layers, const StampPacket&, float*, const float* weight) {
                   layers.open(openings(layers.row().layers)[which], weight);
                 },
                 [&](TileRow& row, int x, std::span<const float> weight) {
                   for (std::size_t i = 0; i < weight.size(); ++i)
                     if (weight[i] != 0)
                       open_plainly(openings(row.layers)[which], row.row(x), static_cast<int>(i));
                 }});
}

/// Paint for 64 cells of each channel; the last channel gets none.
std::vector<PacketValues> some_paint(int channels) {
  std::vector<PacketValues> paint(static_cast<std::size_t>(channels));
  for (std::size_t c = 0; c + 1 < paint.size(); ++c)
    for (std::size_t i = 0; i < paint[c].size(); ++i)
      paint[c][i] = static_cast<float>((3 * c + 5 * i) % 11) / 7;
  return paint;
}

/// The layer that the i-th own cell of a packet takes; none for some.
std::int8_t target_of(int i, int layers) {
  return static_cast<std::int8_t>(i % 6 == 2 ? -1 : i / 5 % layers);
}

TEST(PacketLayers, APickUpThenPaintThenMixingAreThoseOfARow) {
  const PickUp pick_up{0.7f, 0.5f, 0.2f};
  const MixLayers mix{0.4f, 0.2f};
  for (const bool opens : {false, true})
    expect_same(
        {[&](PacketLayers& layers, const StampPacket& packet, float* depth_m, const float* weight) {
           layers.pick_up(pick_up, weight, depth_m);
           const std::vector<PacketValues> paint = some_paint(layers.row().channels);
           std::vector<const float*> of_channel;
           for (const PacketValues& values : paint) of_channel.push_back(values.data());
           std::array<std::int8_t, kPacketCells> target;
           target.fill(-1);
           for (int i = packet.begin; i < packet.end; ++i)
             target[static_cast<std::size_t>(i)] = target_of(i - packet.begin, layers.row().layers);
           if (opens) layers.open(openings(layers.row().layers)[0], weight);
           layers.lay(target.data(), weight, of_channel);
           layers.mix(mix, weight);
         },
         [&](TileRow& row, int x, std::span<const float> weight) {
           pick_up_plainly(pick_up, row, x, weight);
           const std::vector<PacketValues> paint = some_paint(row.channels);
           const int own = static_cast<int>(weight.size());
           const auto begin = static_cast<std::size_t>(
               packet_at(x, own, static_cast<int>(row.depth_m.size())).begin);
           for (int i = 0; i < own; ++i) {
             const auto at = static_cast<std::size_t>(i);
             if (opens && weight[at] != 0) open_plainly(openings(row.layers)[0], row.row(x), i);
             const int layer = target_of(i, row.layers);
             for (int c = 0; layer >= 0 && c < row.channels; ++c)
               row.row(x).at(layer, c, i) +=
                   weight[at] * paint[static_cast<std::size_t>(c)][begin + at];
           }
           mix_layers_row(mix, row.row(x), weight);
         }});
}

// What a stamp brings into a layer, the next one finds there: by mixing, opening and laying.
TEST(PacketLayers, TheNextStampFindsWhatThisOneBrought) {
  const PickUp pick_up{0.7f, -1, 0};
  const MixLayers mix{0.4f, 0.2f};
  const LayerOpening full = opening_of(std::vector<float>{1, 1});
  const StampPacket packet = packet_at(0, 16, 128);
  PacketValues weight;
  weight.fill(1);
  std::array<std::int8_t, kPacketCells> target;
  target.fill(1);
  for (const int by : {0, 1, 2}) {
    // Two layers of two channels; one plane of the first channel is empty, and gets paint.
    TileRow fast(2, 2, 128, 7);
    fast.amount = {1, 1};
    for (std::vector<float>& plane : fast.planes) std::fill(plane.begin(), plane.end(), 1.0f);
    std::vector<float>& empty = fast.planes[by == 1 ? 0 : 2];
    std::fill(empty.begin(), empty.end(), 0.0f);
    PacketLayers layers;
    layers.begin_rows(fast.row(0).plane, 128);
    layers.begin(fast.row(0), packet);
    if (by == 0) layers.mix(mix, weight.data());
    if (by == 1) layers.open(full, weight.data());
    if (by == 2) {
      const std::array<const float*, 2> paint = {weight.data(), weight.data()};
      layers.lay(target.data(), weight.data(), paint);
    }
    TileRow plain = fast;
    layers.begin(fast.row(0), packet);
    layers.pick_up(pick_up, weight.data(), fast.depth_m.data());
    pick_up_plainly(pick_up, plain, 0, {weight.data(), 16});
    EXPECT_TRUE(fast == plain) << by;
  }
}

}  // namespace
}  // namespace pentimento

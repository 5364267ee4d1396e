#include "core/layers/deposit.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/random.h"
#include "core/layers/open_layer.h"
#include "tests/core/layers/layer_cells.h"

namespace pentimento {
namespace {

TEST(Deposit, AddsToTheOpenedLayerAndSetsTheId) {
  LayerCells cells(2, 2);
  cells.set(0, {0.5f, 0});
  cells.state().stroke(0, 0) = 3;
  std::vector<float> paint = {0.25f, 0.125f, 0.0625f, 0};
  std::vector<double> sums(3);
  deposit_row({1, 4}, cells.row(), cells.state().depth_m.view().row_span(0),
              cells.state().stroke.row(0), paint.data(), 4, sums);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.5f, 0.125f}));
  EXPECT_EQ(cells.get(1), (std::vector<float>{0, 0.0625f}));
  EXPECT_EQ(cells.state().depth_m(0, 0), 0.25f);
  EXPECT_EQ(cells.state().stroke(0, 0), 4u);
  EXPECT_EQ(sums, (std::vector<double>{0.25, 0.125, 0.0625}));
}

TEST(Deposit, WhatDoesNotFitStaysInTheBrushWithItsPigment) {
  LayerCells cells(2, 1);
  cells.state().depth_m(0, 0) = 0.75f;
  std::vector<float> paint = {0.5f, 0.5f, 0, 0};
  std::vector<double> sums(2);
  deposit_row({1, 4}, cells.row(), cells.state().depth_m.view().row_span(0),
              cells.state().stroke.row(0), paint.data(), 4, sums);
  EXPECT_EQ(cells.state().depth_m(0, 0), 1.0f);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.25f, 0}));
  EXPECT_EQ(paint[0], 0.25f);
}

TEST(Deposit, NothingLaidChangesNothing) {
  LayerCells cells(2, 1);
  cells.set(0, {0.5f, 0.25f});
  cells.state().stroke(0, 0) = 3;
  std::vector<float> paint(4, 0.0f);
  std::vector<double> sums(2);
  deposit_row({1, 4}, cells.row(), cells.state().depth_m.view().row_span(0),
              cells.state().stroke.row(0), paint.data(), 4, sums);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.5f, 0.25f}));
  EXPECT_EQ(cells.state().stroke(0, 0), 3u);
}

/// The definition, cell by cell and component by component.
void deposit_plainly(const Deposit& deposit, const LayerRow& row, std::span<float> depth_m,
                     std::uint32_t* stroke, float* paint, int stride) {
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    float* p = paint + static_cast<std::ptrdiff_t>(i) * stride;
    if (std::all_of(p, p + 1 + row.channels, [](float v) { return v == 0; })) continue;
    const float room_m = std::max(0.0f, deposit.max_depth_m - depth_m[i]);
    if (p[0] > room_m) {
      const float fits = room_m / p[0];
      for (int k = 0; k <= row.channels; ++k) p[k] *= fits;
    }
    const int x = static_cast<int>(i);
    const int layer = open_layer(row, x, deposit.stroke_id, stroke[i]);
    depth_m[i] += p[0];
    for (int c = 0; c < row.channels; ++c) row.at(layer, c, x) += p[1 + c];
    stroke[i] = deposit.stroke_id;
  }
}

TEST(Deposit, ALongRowIsDoneAsItsCellsOneByOne) {
  constexpr int kCells = 150, kChannels = 5, kStride = 8, kLayers = 3;
  LayerCells packets(kLayers, kChannels, kCells), plain(kLayers, kChannels, kCells);
  std::vector<float> paint(static_cast<std::size_t>(kCells * kStride), 0.0f);
  std::uint64_t n = 0;
  const auto share = [&] { return static_cast<float>(splitmix64(3, ++n) >> 40) * 0x1p-24f; };
  for (int x = 0; x < kCells; ++x) {
    // Cells with 0 to 3 layers, of this stroke or of another; every fourth gets no paint, and
    // channel 2 is in nobody's brush.
    const int layers = x % 4;
    for (LayerCells* cells : {&packets, &plain}) cells->state().stroke(x, 0) = x % 3 == 0 ? 9 : 4;
    for (int layer = 0; layer < layers; ++layer)
      for (int c = 0; c < kChannels; ++c) {
        const float amount = share();
        for (LayerCells* cells : {&packets, &plain})
          cells->state().channel(layer, c)(x, 0) = amount;
      }
    if (x % 4 == 1) continue;
    for (int k = 0; k <= kChannels; ++k)
      if (k != 3) paint[static_cast<std::size_t>(x * kStride + k)] = 0.01f * share();
    if (x % 5 == 0) paint[static_cast<std::size_t>(x * kStride)] = 2;  // does not fit
  }
  std::vector<float> plain_paint = paint;
  std::vector<double> sums(1 + kChannels);
  deposit_row({1, 4}, packets.row(), packets.state().depth_m.view().row_span(0),
              packets.state().stroke.row(0), paint.data(), kStride, sums);
  deposit_plainly({1, 4}, plain.row(), plain.state().depth_m.view().row_span(0),
                  plain.state().stroke.row(0), plain_paint.data(), kStride);
  EXPECT_EQ(paint, plain_paint);
  double gained = 0;
  for (int x = 0; x < kCells; ++x) {
    EXPECT_EQ(packets.state().depth_m(x, 0), plain.state().depth_m(x, 0)) << x;
    EXPECT_EQ(packets.state().stroke(x, 0), plain.state().stroke(x, 0)) << x;
    for (int c = 0; c < kChannels; ++c) EXPECT_EQ(packets.get(c, x), plain.get(c, x)) << x;
    gained += static_cast<double>(plain.state().depth_m(x, 0));
  }
  EXPECT_NEAR(sums[0], gained, 1e-13);  // 150 sums of up to 1, in another order
  EXPECT_EQ(sums[3], 0);
}

}  // namespace
}  // namespace pentimento

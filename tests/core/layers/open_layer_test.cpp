#include "core/layers/open_layer.h"

#include <gtest/gtest.h>

#include "tests/core/layers/layer_cells.h"

namespace pentimento {
namespace {

using Amounts = std::vector<float>;

TEST(OpenLayer, AFreshCellTakesTheBottomLayer) {
  LayerCells cells(3, 1);
  EXPECT_EQ(open_layer(cells.row(), 0, 1, 0), 0);
}

TEST(OpenLayer, TheSameStrokeStaysInItsLayer) {
  LayerCells cells(3, 1);
  cells.set(0, {0.5f, 0.25f, 0});
  EXPECT_EQ(open_layer(cells.row(), 0, 7, 7), 1);
  EXPECT_EQ(cells.get(0), (Amounts{0.5f, 0.25f, 0}));
}

TEST(OpenLayer, AnotherStrokeTakesTheLowestFreeLayer) {
  LayerCells cells(4, 1);
  cells.set(0, {0.5f, 0.25f, 0, 0});
  EXPECT_EQ(open_layer(cells.row(), 0, 8, 7), 2);
}

TEST(OpenLayer, HolesAreClosedFirst) {
  LayerCells cells(4, 2);
  cells.set(0, {0, 0.5f, 0, 0.125f});
  cells.set(1, {0, 0.25f, 0, 0});
  EXPECT_EQ(open_layer(cells.row(), 0, 8, 7), 2);
  EXPECT_EQ(cells.get(0), (Amounts{0.5f, 0.125f, 0, 0}));
  EXPECT_EQ(cells.get(1), (Amounts{0.25f, 0, 0, 0}));
}

TEST(OpenLayer, WhenAllAreFullTheBottomTwoMerge) {
  LayerCells cells(4, 1);
  cells.set(0, {0.5f, 0.25f, 0.125f, 0.0625f});
  EXPECT_EQ(open_layer(cells.row(), 0, 8, 7), 3);
  EXPECT_EQ(cells.get(0), (Amounts{0.75f, 0.125f, 0.0625f, 0}));
}

TEST(OpenLayer, TwoLayersMergeIntoOne) {
  LayerCells cells(2, 2);
  cells.set(0, {0.5f, 0});
  cells.set(1, {0, 0.25f});
  EXPECT_EQ(open_layer(cells.row(), 0, 8, 7), 1);
  EXPECT_EQ(cells.get(0), (Amounts{0.5f, 0}));
  EXPECT_EQ(cells.get(1), (Amounts{0.25f, 0}));
}

TEST(OpenLayer, ASingleLayerIsAddedTo) {
  LayerCells cells(1, 1);
  cells.set(0, {0.5f});
  EXPECT_EQ(open_layer(cells.row(), 0, 8, 7), 0);
  EXPECT_EQ(cells.get(0), (Amounts{0.5f}));
}

TEST(OpenLayer, SumsAreKeptForAnyNumberOfLayers) {
  for (int layers = 1; layers <= kMaxLayers; ++layers) {
    LayerCells cells(layers, 1);
    float sum = 0;
    for (int k = 0; k < layers; ++k) {
      // Sums of small powers of two are exact, so the test may ask for equality.
      const float amount = k % 3 == 1 ? 0.0f : 1.0f / static_cast<float>(1 << k);
      cells.state().channel(k, 0)(0, 0) = amount;
      sum += amount;
    }
    open_layer(cells.row(), 0, 8, 7);
    float after = 0;
    for (const float amount : cells.get(0)) after += amount;
    EXPECT_EQ(after, sum) << layers << " layers";
  }
}

}  // namespace
}  // namespace pentimento

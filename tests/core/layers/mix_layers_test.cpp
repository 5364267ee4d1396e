#include "core/layers/mix_layers.h"

#include <gtest/gtest.h>

#include "tests/core/layers/layer_cells.h"

namespace pentimento {
namespace {

void mix_one(const MixLayers& mix, LayerCells& cells, float weight = 1) {
  mix_layers_row(mix, cells.row(), {&weight, 1});
}

TEST(MixLayers, NeighboursExchangeOnceByHand) {
  LayerCells cells(3, 1);
  cells.set(0, {1, 0.5f, 0.25f});
  mix_one({0.25f, 0}, cells);
  // P0 + m(P1-P0), P1 + m[(P2-P1)+(P0-P1)], P2 + m(P1-P2), all from the old values.
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.875f, 0.5625f, 0.3125f}));
}

TEST(MixLayers, RepeatedPassesEndWithTheSameInAllLayers) {
  for (int layers = 2; layers <= kMaxLayers; ++layers) {
    LayerCells cells(layers, 2);
    for (int k = 0; k < layers; ++k) {
      cells.state().channel(k, 0)(0, 0) = k == 0 ? 1.0f : 0.01f;
      cells.state().channel(k, 1)(0, 0) = k == layers - 1 ? 0.5f : 0.0f;
    }
    for (int i = 0; i < 2000; ++i) mix_one({0.3f, 0}, cells);
    const float mean0 = (1 + 0.01f * static_cast<float>(layers - 1)) / static_cast<float>(layers);
    const float mean1 = 0.5f / static_cast<float>(layers);
    for (int k = 0; k < layers; ++k) {
      // 2000 passes round 2000 times at 6e-8.
      EXPECT_NEAR(cells.get(0)[static_cast<std::size_t>(k)] / mean0, 1, 1e-4);
      EXPECT_NEAR(cells.get(1)[static_cast<std::size_t>(k)] / mean1, 1, 1e-4);
    }
  }
}

TEST(MixLayers, EmptyLayersAboveStayEmpty) {
  LayerCells cells(3, 1);
  cells.set(0, {1, 0.5f, 0});
  mix_one({0.5f, 0}, cells);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.75f, 0.75f, 0}));
}

TEST(MixLayers, EmptyLayersStayEmptyBesideAHigherCell) {
  LayerCells cells(3, 1, 2);
  cells.set(0, {1, 0.5f, 0.25f});
  cells.state().channel(0, 0)(1, 0) = 1;
  cells.state().channel(1, 0)(1, 0) = 0.5f;
  const float weight[] = {1, 1};
  mix_layers_row({0.5f, 0}, cells.row(), weight);
  EXPECT_EQ(cells.get(0, 1), (std::vector<float>{0.75f, 0.75f, 0}));
}

TEST(MixLayers, ResidueDoesNotLeaveTheBottom) {
  LayerCells cells(2, 1);
  cells.set(0, {0.5f, 0.25f});
  for (int i = 0; i < 500; ++i) mix_one({0.4f, 0.5f}, cells);
  // The bottom's 0.5 stay; what can move, the 0.25 above, is shared.
  EXPECT_NEAR(cells.get(0)[0], 0.625f, 1e-5f);
  EXPECT_NEAR(cells.get(0)[1], 0.125f, 1e-5f);
}

TEST(MixLayers, MoreThanHalfIsTakenAsHalf) {
  LayerCells cells(2, 1);
  cells.set(0, {1, 0.5f});
  mix_one({0.4f, 0}, cells, 2);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.75f, 0.75f}));
}

}  // namespace
}  // namespace pentimento

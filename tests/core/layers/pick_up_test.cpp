#include "core/layers/pick_up.h"

#include <gtest/gtest.h>

#include <array>

#include "tests/core/layers/layer_cells.h"

namespace pentimento {
namespace {

struct PickedUp {
  std::vector<float> paint = std::vector<float>(4, 0.0f);
  std::vector<double> sums = std::vector<double>(3, 0.0);
};

/// Lifts from the single cell of `cells`, two channels.
PickedUp pick_up_one(const PickUp& pick_up, LayerCells& cells, float weight = 1) {
  PickedUp out;
  pick_up_row(pick_up, cells.row(), {&weight, 1}, cells.state().depth_m.row(0), out.paint.data(), 4,
              out.sums);
  return out;
}

TEST(PickUp, WithoutPressureAllLayersGiveAlike) {
  LayerCells cells(3, 2);
  cells.state().depth_m(0, 0) = 1;
  cells.set(0, {0.5f, 0.25f, 0});
  cells.set(1, {0, 0.5f, 0});
  const PickedUp out = pick_up_one({0.5f, -1, 0}, cells);
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.25f, 0.125f, 0}));
  EXPECT_EQ(cells.get(1), (std::vector<float>{0, 0.25f, 0}));
  EXPECT_EQ(cells.state().depth_m(0, 0), 0.5f);
  EXPECT_EQ(out.paint, (std::vector<float>{0.5f, 0.375f, 0.25f, 0}));
  EXPECT_EQ(out.sums, (std::vector<double>{0.5, 0.375, 0.25}));
}

TEST(PickUp, SoftBristlesReachTheTopLayerOnly) {
  LayerCells cells(2, 2);
  cells.state().depth_m(0, 0) = 1;
  cells.set(0, {0.5f, 0.25f});
  pick_up_one({0.5f, 0.5f, 0}, cells);  // half of two layers: the upper one
  EXPECT_EQ(cells.get(0), (std::vector<float>{0.5f, 0.125f}));
  EXPECT_EQ(cells.state().depth_m(0, 0), 0.75f);  // its half of the film
}

TEST(PickUp, ReachGoesDownThroughTheLayers) {
  EXPECT_EQ(penetration_weight(-1, 0, 4), 1);
  EXPECT_EQ(penetration_weight(1, 0, 4), 1);
  EXPECT_EQ(penetration_weight(0.5f, 3, 4), 1);
  EXPECT_EQ(penetration_weight(0.5f, 2, 4), 1);
  EXPECT_EQ(penetration_weight(0.5f, 1, 4), 0);
  EXPECT_EQ(penetration_weight(0.375f, 2, 4), 0.5f);
  EXPECT_EQ(penetration_weight(0, 3, 4), 0);
}

TEST(PickUp, TheResidueStaysOnThePaper) {
  LayerCells cells(2, 2);
  cells.state().depth_m(0, 0) = 1;
  cells.set(0, {0.25f, 0});
  cells.set(1, {0.75f, 0});
  for (int i = 0; i < 200; ++i) pick_up_one({0.5f, -1, 0.5f}, cells);
  // Of 1 in all, 0.5 stays, in the same proportion.
  EXPECT_NEAR(cells.get(0)[0], 0.125f, 1e-6f);
  EXPECT_NEAR(cells.get(1)[0], 0.375f, 1e-6f);
}

TEST(PickUp, TakesClearMediumToo) {
  LayerCells cells(2, 2);
  cells.state().depth_m(0, 0) = 0.5f;
  const PickedUp out = pick_up_one({0.5f, -1, 0.01f}, cells, 0.5f);
  EXPECT_EQ(out.sums[0], 0.125);
  EXPECT_EQ(cells.state().depth_m(0, 0), 0.375f);
}

TEST(PickUp, SumsAreExactlyWhatTheCanvasLost) {
  LayerCells cells(2, 2);
  cells.state().depth_m(0, 0) = 0.001234f;
  cells.set(0, {0.0211f, 0.0173f});
  const double before = static_cast<double>(0.0211f) + static_cast<double>(0.0173f);
  const PickedUp out = pick_up_one({0.0089f, -1, 0.01f}, cells);
  const auto after = cells.get(0);
  EXPECT_EQ(out.sums[1], before - static_cast<double>(after[0]) - static_cast<double>(after[1]));
}

}  // namespace
}  // namespace pentimento

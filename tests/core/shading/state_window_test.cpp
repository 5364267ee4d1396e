#include "core/shading/state_window.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

CanvasState small_state() {
  CanvasState s = make_canvas_state({3, 2, 1, 1}, 1, 5, 3, 0.5f);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      const float id = static_cast<float>(10 * y + x);
      s.depth_m(x, y) = id;
      s.base_m(x, y) = 100;
      s.paper.set(x, y, 100, 60);
      s.channel(0, 4)(x, y) = -id;
    }
  }
  return s;
}

/// Optics of the small state, whose channels have no colour: the dry reflectance as it is.
AlbedoOptics bare() {
  AlbedoOptics out{{}, Eigen::Matrix3Xf::Identity(3, 3), 0, 0};
  out.paint.K = out.paint.S = Eigen::MatrixXf::Zero(3, 5);
  out.paint.amount = Eigen::VectorXf::Ones(5);
  return out;
}

TEST(PackGround, RepeatsTheEdgeBeyondTheGrid) {
  const CanvasState state = small_state();
  std::vector<float> texels;
  pack_albedo(StateSource(state), bare(), EdgeCells::kPartlyCovered, {-2, -1, 7, 4}, Threads(2),
              texels);
  ASSERT_EQ(texels.size(), 4u * 7 * 4);
  const float expected[4][7] = {{0, 0, 0, 1, 2, 2, 2},
                                {0, 0, 0, 1, 2, 2, 2},
                                {10, 10, 10, 11, 12, 12, 12},
                                {10, 10, 10, 11, 12, 12, 12}};
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < 7; ++x) {
      EXPECT_EQ(texels[4 * (7 * y + x) + 3], expected[y][x]);
      EXPECT_EQ(texels[4 * (7 * y + x)], 0.5f);
    }
  }
}

TEST(PackGround, AcceptsAWindowWhollyBeyondTheGrid) {
  const CanvasState state = small_state();
  std::vector<float> texels;
  pack_albedo(StateSource(state), bare(), EdgeCells::kPartlyCovered, {5, 5, 2, 1}, Threads(1),
              texels);
  EXPECT_EQ(texels[3], 12);
  pack_albedo(StateSource(state), bare(), EdgeCells::kPartlyCovered, {-9, -9, 2, 1}, Threads(1),
              texels);
  EXPECT_EQ(texels[7], 0);
}

TEST(PackRelief, HoldsHeightAndThicknessOfAllPaint) {
  const CanvasState state = small_state();
  std::vector<float> texels;
  pack_relief(StateSource(state), {1, 1, 1, 1}, Threads(1), texels);
  EXPECT_EQ(texels, (std::vector<float>{111, 51}));
}

TEST(PackAmounts, FillsMissingChannelsWithZeros) {
  const CanvasState state = small_state();
  std::vector<float> texels(100, 7.0f);
  pack_amounts(StateSource(state), 1, {2, 1, 1, 1}, Threads(1), texels);
  EXPECT_EQ(texels, (std::vector<float>{-12, 0, 0, 0}));
}

TEST(PackAmounts, AddsUpTheLayers) {
  CanvasState state = make_canvas_state({20, 30, 1, 1}, 3, 2, 3, 0.5f);
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 2; ++c) state.channel(k, c).fill(static_cast<float>(10 * c + k));
  }
  std::vector<float> texels;
  pack_amounts(StateSource(state), 0, {0, 0, 20, 30}, Threads(3), texels);
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    EXPECT_EQ(texels[i], 0 + 1 + 2);
    EXPECT_EQ(texels[i + 1], 30 + 1 + 2);
    EXPECT_EQ(texels[i + 2], 0);
  }
}

}  // namespace
}  // namespace pentimento

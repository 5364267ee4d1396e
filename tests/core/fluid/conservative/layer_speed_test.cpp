#include <gtest/gtest.h>

#include <array>

#include "core/fluid/conservative/advection/layer_speed_row.h"
#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

TEST(LayerSpeed, LiesByItsShareOfThePigment) {
  // A quarter of the pigment under three quarters: middles at 1/8 and at 5/8; a layer alone in the
  // middle of the film, whichever it is.
  const std::array<float, 3> bottom = {1, 2, 0}, top = {3, 0, 5}, total = {4, 2, 5};
  std::array<float, 3> below{}, low{}, high{};
  layer_middle_row(bottom.data(), total.data(), 3, below.data(), low.data());
  layer_middle_row(top.data(), total.data(), 3, below.data(), high.data());
  EXPECT_EQ(low, (std::array<float, 3>{0.125f, 0.5f, 0}));
  EXPECT_EQ(high, (std::array<float, 3>{0.625f, 0, 0.5f}));
}

TEST(LayerSpeed, MovesThePigmentOfAllLayersWithTheOil) {
  // Sum of a_k 2 z_k = sum of a_k, to rounding.
  const std::array<float, 4> amount = {0.3f, 0.01f, 2.0f, 0.7f};
  float total = 0, below = 0, moved = 0;
  for (const float a : amount) total += a;
  for (const float& a : amount) {
    float middle = 0;
    layer_middle_row(&a, &total, 1, &below, &middle);
    moved += 2 * middle * a;
  }
  EXPECT_NEAR(moved, total, 1e-6f);
}

TEST(LayerSpeed, TakesTheMeanOfTheCellsThatHaveTheLayer) {
  const std::array<float, 3> a = {0.2f, 0, 0.2f}, b = {0.4f, 0.4f, 0}, flow = {1, 1, 1}, push{};
  std::array<float, 3> out{};
  layer_speed_row(2, a.data(), b.data(), flow.data(), push.data(), 3, out.data());
  EXPECT_FLOAT_EQ(out[0], 0.6f);
  EXPECT_FLOAT_EQ(out[1], 0.8f);
  EXPECT_FLOAT_EQ(out[2], 0.4f);
}

TEST(LayerSpeed, LeavesTheFrontOfARunAsFluidAsItsBody) {
  // Two layers of a wash that runs under tilt. Layers of equal thickness brought six times as much
  // pigment per oil to the front, which set there; what is left, 1.31, comes of the remap.
  Basin b({128, 96, 0.125, 0.09375}, 2, 2);
  b.gravity_m_s2 = {1.5f, -4.5f, 8};
  constexpr float kTheta = 3.5f;
  b.fill_depth([](int x, int y) {
    const float r = std::hypot(static_cast<float>(x - 60) / 40, static_cast<float>(y - 30) / 18);
    return r < 1 ? 0.004f * (1 - r * r * r * r) : 0.0f;
  });
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 128; ++x)
      for (int k = 0; k < 2; ++k)
        b.state.channel(k, k)(x, y) = 0.5f * kTheta * b.state.depth_m(x, y);
  b.steps(90);
  float most = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 128; ++x) {
      const float depth = b.state.depth_m(x, y);
      if (depth < b.model.dry_film_m()) continue;
      most = std::max(most, (b.state.channel(0, 0)(x, y) + b.state.channel(1, 1)(x, y)) / depth);
    }
  EXPECT_LT(most, 1.5f * kTheta);
}

}  // namespace
}  // namespace pentimento::conservative

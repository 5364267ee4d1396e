#include "core/fluid/rheology.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento {
namespace {

TEST(Rheology, TakesAlphaAndBetaFromTable1) {
  const Rheology r = make_rheology(Model{});
  EXPECT_FLOAT_EQ(r.alpha_per_m, 4);
  EXPECT_FLOAT_EQ(r.beta_per_m, 16);
}

TEST(Rheology, StiffnessHasThePublishedValues) {
  const Rheology r;
  EXPECT_EQ(r.stiffness(0), 0);
  EXPECT_EQ(r.stiffness(4), 0);
  EXPECT_FLOAT_EQ(r.stiffness(7), 0.15625f);
  EXPECT_FLOAT_EQ(r.stiffness(10), 0.5f);
  EXPECT_FLOAT_EQ(r.stiffness(13), 0.84375f);
  EXPECT_EQ(r.stiffness(16), 1);
  EXPECT_EQ(r.stiffness(20), 1);
  EXPECT_EQ(r.stiffness(std::numeric_limits<float>::infinity()), 1);
}

TEST(Rheology, ViscosityIsLinearBetweenItsBounds) {
  const Rheology r;
  EXPECT_FLOAT_EQ(r.viscosity_m2_s(0), 1e-6f);
  EXPECT_FLOAT_EQ(r.viscosity_m2_s(10), 5.0005e-3f);
  EXPECT_FLOAT_EQ(r.viscosity_m2_s(100), 1e-2f);
}

TEST(Rheology, BarePigmentIsStiffAndBareCanvasIsNot) {
  EXPECT_TRUE(std::isinf(pigment_per_volume(0.01f, 0)));
  EXPECT_EQ(pigment_per_volume(0, 0), 0);
  EXPECT_FLOAT_EQ(pigment_per_volume(1, 0.05f), 20);
}

TEST(Rheology, AmountsAreWeightedOverLayersAndChannels) {
  CanvasState s = make_canvas_state({3, 1, 1, 1}, 2, 2, 3, 0.9f);
  s.channel(0, 0)(1, 0) = 1;
  s.channel(0, 1)(1, 0) = 2;
  s.channel(1, 0)(1, 0) = 4;
  s.channel(1, 1)(2, 0) = 8;
  std::vector<float> out(2);
  total_amount_row(s, {1.0f, 0.5f}, 0, 1, 3, out);
  EXPECT_EQ(out[0], 1 + 0.5f * 2 + 4);
  EXPECT_EQ(out[1], 0.5f * 8);
}

TEST(Rheology, ThinFilmsFeelNoGravity) {
  const std::vector<float> depth = {0.0004f, 0.001f, 0.001f, 0.0f}, amount = {0, 0, 0.01f, 0.01f};
  std::vector<float> mobility(4), nu(4);
  rheology_row(Rheology{}, 5e-4f, depth, amount, mobility, nu);
  EXPECT_EQ(mobility[0], 0);
  EXPECT_EQ(mobility[1], 1);
  EXPECT_FLOAT_EQ(mobility[2], 0.5f);
  EXPECT_FLOAT_EQ(nu[2], 5.0005e-3f);
  EXPECT_EQ(mobility[3], 0);
  EXPECT_FLOAT_EQ(nu[3], 1e-2f);
}

TEST(Rheology, TheTotalAmountIsSummedPlaneAfterPlane) {
  // 3 layers of 3 channels, of which one does not count: 6 planes, four of them at once.
  CanvasState s = make_canvas_state({40, 2, 0.04, 0.002}, 3, 3, 1, 0);
  const std::vector<float> amount{0.7f, 0, 1.3f};
  for (std::size_t k = 0; k < s.pigment.size(); ++k)
    for (int x = 0; x < 40; ++x)
      s.pigment[k](x, 1) = 0.1f * static_cast<float>((static_cast<int>(k) * 7 + x * 3) % 11);
  std::vector<float> out(35);
  total_amount_row(s, amount, 1, 2, 37, out);
  for (int x = 2; x < 37; ++x) {
    float sum = 0;
    for (int layer = 0; layer < 3; ++layer)
      for (const int c : {0, 2})
        sum += amount[static_cast<std::size_t>(c)] * s.channel(layer, c)(x, 1);
    EXPECT_EQ(out[static_cast<std::size_t>(x - 2)], sum) << x;
  }
}

}  // namespace
}  // namespace pentimento

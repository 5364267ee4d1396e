#include "core/fluid/conservative/solve/capillary_row.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace pentimento::conservative {
namespace {

TEST(CapillaryRow, AFilmEndsWherePaintDoes) {
  const float a[] = {1e-3f, 1e-3f, 0, 4e-5f}, b[] = {2e-3f, 4e-5f, 1e-3f, 5e-5f};
  float weight[4];
  film_weight_row(a, b, 5e-5f, 7, 4, weight);
  EXPECT_EQ(weight[0], 7);
  EXPECT_EQ(weight[1], -14);  // an edge is half a cell away
  EXPECT_EQ(weight[2], -14);
  EXPECT_EQ(weight[3], 0);
}

TEST(CapillaryRow, TheHeadIsTheCurvatureOfAParaboloid) {
  // h = 3 x^2 - 2 y^2 + x + 4: lap h = 2, at every cell, on cells of 1 by 2.
  std::array<std::array<float, 6>, 3> h;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 6; ++x) {
      const float fx = static_cast<float>(x), fy = 2 * static_cast<float>(y);
      h[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] =
          3 * fx * fx - 2 * fy * fy + fx + 4;
    }
  std::vector<float> across(6, 1.0f), down(6, 0.25f);
  const std::vector<float> base(6, 0.0f);
  float head[4];
  curvature_row({h[0].data() + 1, h[1].data() + 1, h[2].data() + 1, base.data() + 1,
                 across.data() + 1, down.data() + 1, down.data() + 1},
                {}, 0.5f, 4, head);
  for (const float value : head) EXPECT_EQ(value, 0.5f * 2);
}

TEST(CapillaryRow, AWallHasNoSlope) {
  // A film of one height beside walls on the right and above: what is behind them does not matter.
  const float above[] = {9, 9, 9}, here[] = {1, 1, 8}, below[] = {1, 1, 1}, base[] = {0, 0, 0};
  const float across[] = {1, 0, 0}, none[] = {0, 0, 0}, all[] = {1, 1, 1};
  float head = 1;
  curvature_row({above + 1, here + 1, below + 1, base + 1, across + 1, none + 1, all + 1}, {2, 2},
                1, 1, &head);
  EXPECT_EQ(head, 0);
}

TEST(CapillaryRow, AtAnEdgeTheSurfaceComesDownToTheCanvas) {
  // A cell of height 3 on a base of 1 with edges right, left, above and below: down by its depth,
  // or as far as the slope allows.
  const float low[] = {1, 1, 1}, here[] = {1, 3, 1}, base[] = {1, 1, 1};
  const float edge[] = {-2, -2}, right[] = {0, -2}, left[] = {-2, 0}, none[] = {0, 0};
  const auto head_of = [&](const float* across, const float* up, const float* down, EdgeDrop most) {
    float head = 1;
    curvature_row({low + 1, here + 1, low + 1, base + 1, across + 1, up, down}, most, 1, 1, &head);
    return head;
  };
  EXPECT_EQ(head_of(right, none, none, {9, 9, 99}), -4);
  EXPECT_EQ(head_of(left, none, none, {9, 9, 99}), -4);
  EXPECT_EQ(head_of(right, none, none, {0.5f, 9, 99}), -1);
  EXPECT_EQ(head_of(none, edge, none, {9, 9, 99}), -4);
  EXPECT_EQ(head_of(none, edge, none, {9, 0.5f, 99}), -1);
  EXPECT_EQ(head_of(none, none, edge, {9, 0.5f, 99}), -1);
  EXPECT_EQ(head_of(edge, edge, edge, {9, 0.5f, 99}), -4 - 4 - 1 - 1);
}

TEST(CapillaryRow, ACoastThatRisesHasNoSlope) {
  // A cell of height 3 and depth 2: bare canvas beside it at 2 takes half the depth off the
  // drop, canvas at 4 all of it; a pit beside it adds nothing.
  const float same[] = {3, 3, 3}, base[] = {0, 1, 0}, none[] = {0, 0}, right[] = {0, -2};
  for (const auto& [beside, expected] : {std::pair{2.0f, -2.0f}, {4.0f, 0.0f}, {-5.0f, -4.0f}}) {
    const float here[] = {3, 3, beside};
    float head = 1;
    curvature_row({same + 1, here + 1, same + 1, base + 1, right + 1, none, none}, {9, 9, 99}, 1, 1,
                  &head);
    EXPECT_EQ(head, expected) << beside;
  }
}

TEST(CapillaryRow, ADeepEdgeHasNoSlope) {
  // The surface carries 10: up to 3 the edge drops by 1, from 6 on by nothing.
  const float base[] = {0, 0, 0}, none[] = {0, 0}, right[] = {0, -2};
  for (const auto& [height, expected] :
       {std::pair{3.0f, -2.0f}, {4.5f, -1.0f}, {6.0f, 0.0f}, {60.0f, 0.0f}}) {
    const float here[] = {height, height, 0};
    float head = 1;
    curvature_row({base + 1, here + 1, base + 1, base + 1, right + 1, none, none}, {1, 1, 10}, 1, 1,
                  &head);
    EXPECT_FLOAT_EQ(head, expected) << height;
  }
}

TEST(CapillaryRow, ForeseesLessOfWhatDeepFilmsDo) {
  // Carried: 2 mm. A surface that falls by 1 um is trusted by 0.9 in films up to that, by 0.5 in
  // films of twice that.
  const float depth[] = {0, 0.002f, 0.003f, 0.004f, 0.04f}, height[] = {0, 0, 0, 0, 0};
  float surface[] = {-1e-6f, -1e-6f, -1e-6f, -1e-6f, -1e-6f};
  foresee_row(depth, height, 0.002f, 5, surface);
  const float expected[] = {-0.9e-6f, -0.9e-6f, -0.7e-6f, -0.5e-6f, -0.5e-6f};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(surface[i], expected[i], 1e-12f) << i;
}

struct Face {
  float velocity_m_s, held_m_s2;
};
Face force(float depth_m, float hanging_m_s2, float weight) {
  const float mobility = 0.5f, friction = 0.8f;
  const float head_a = 1, head_b = 3, height_a = 0.002f, height_b = 0.0015f;
  Face face{0.25f, -1};
  capillary_force_row(
      {0.1f, 1000, 1e-5f, 8e6f, 1e9f, hanging_m_s2},
      {&weight, &depth_m, &mobility, &friction, &head_a, &head_b, &height_a, &height_b}, 1,
      &face.velocity_m_s, &face.held_m_s2);
  return face;
}

TEST(CapillaryRow, AThinFilmHasTheExactForce) {
  // dt^2 K d L = 0.01 0.4 1e-7 8e6 = 0.0032; s L = 80; 80 0.0032 < 1: nothing is held.
  const Face face = force(1e-7f, 0, 1);
  EXPECT_EQ(face.held_m_s2, 0);
  EXPECT_NEAR(face.velocity_m_s, 0.25f + 0.1f * 0.4f * 2 * 1000, 1e-5f);
}

TEST(CapillaryRow, ADeepFilmHoldsWhatItsShortestWaveNeeds) {
  // dt^2 K d L = 32: held = 80 - 1/32.
  const Face face = force(1e-3f, 0, 1);
  EXPECT_NEAR(face.held_m_s2, 80 - 1.0 / 32, 1e-4);
  const double pull = 2 + (80 - 1.0 / 32) * -0.0005;
  EXPECT_NEAR(face.velocity_m_s, 0.25 + 0.1 * 0.4 * pull * 1000, 1e-4);
}

TEST(CapillaryRow, HangingPaintIsPulledToWhereItIsDeeper) {
  // The surface falls from a to b: paint runs back to a, by 10 m/s^2 times the slope of 0.5.
  const double more = static_cast<double>(force(1e-7f, 10, 1).velocity_m_s) -
                      static_cast<double>(force(1e-7f, 0, 1).velocity_m_s);
  EXPECT_NEAR(more, -0.1 * 0.4 * 10 * 0.5, 1e-4);
}

TEST(CapillaryRow, AHeapThatItsSurfaceCannotCarrySags) {
  // Without tension nothing else is held. Up to 2 mm nothing sags, from twice that all of 12 m/s^2.
  const float depth[] = {0.001f, 0.002f, 0.003f, 0.004f, 0.1f, 0.1f};
  const float weight[] = {1, 1, 1, 1, 1, 0}, half[] = {0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f};
  const float none[] = {0, 0, 0, 0, 0, 0}, rise[] = {1, 1, 1, 1, 1, 1};
  float velocity[] = {0, 0, 0, 0, 0, 0}, held[6];
  capillary_force_row({.dt_s = 0.1f,
                       .per_d_per_m = 1000,
                       .tension_m3_s2 = 0,
                       .stiffest_per_m2 = 8e6f,
                       .sagging_m_s2 = 12,
                       .carried_m = 0.002f},
                      {weight, depth, half, half, none, none, none, rise}, 6, velocity, held);
  const float expected[] = {0, 0, 6, 12, 12, 0};
  for (int i = 0; i < 6; ++i) {
    EXPECT_NEAR(held[i], expected[i], 1e-5f) << i;
    EXPECT_EQ(velocity[i], 0) << i << ": it is left to the height solve";
  }
}

TEST(CapillaryRow, NothingPullsAtTheEdgeOfAFilm) {
  const Face face = force(1e-3f, 10, 0);
  EXPECT_EQ(face.velocity_m_s, 0.25f);
  EXPECT_EQ(face.held_m_s2, 0);
}

}  // namespace
}  // namespace pentimento::conservative

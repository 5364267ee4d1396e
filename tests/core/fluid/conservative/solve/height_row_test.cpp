#include "core/fluid/conservative/solve/height_row.h"

#include <gtest/gtest.h>

#include <array>

namespace pentimento::conservative {
namespace {

TEST(CrowdingRow, IsOfThePaintAloneNotOfTheBaseUnderIt) {
  // It starts at 50 mm and is whole 10 mm above. Paint 55 mm deep, now or to come, has half of it,
  // on a base of 0 as on one of 100 mm.
  const Crowding crowding{0.05f, 0.01f, 200};
  const std::array<float, 6> depth = {0.055f, 0.055f, 0.01f, 0.01f, 0.01f, 0.07f};
  const std::array<float, 6> base = {0, 0.1f, 0, 0.1f, 0.1f, 0.1f};
  std::array<float, 6> out = {0.01f, 0.11f, 0.055f, 0.155f, 0.11f, 0.11f};  // heights to come
  crowding_row(crowding, depth.data(), base.data(), 6, out.data());
  const std::array<float, 6> expected = {100, 100, 100, 100, 0, 200};
  // Heights of 0.15 m are rounded to 1e-8, of which 200 / 0.01 makes 2e-4.
  for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(out[i], expected[i], 1e-3f) << i;
}

TEST(PressureRow, AddsGravityAndWhatTheTensionHolds) {
  // K = dt friction (mobility (g + held) + crowding) = 0.1 0.5 (0.25 (2 + 6) + 8); d_f dt/dx^2 = 3.
  const float depth = 3, mobility = 0.25f, friction = 0.5f, crowding_a = 8, crowding_b = 1;
  float pressure = 6, coupling = 0;  // `held` on entry
  pressure_row({&depth, &mobility, &friction, &crowding_a, &crowding_b}, 0.1f * 2, 0.1f, 1, 1,
               &pressure, &coupling);
  EXPECT_NEAR(pressure, 0.5f, 1e-7f);
  EXPECT_NEAR(coupling, 1.5f, 3e-7f);
}

TEST(FinishRow, CapsPaintInBothDirections) {
  // On a level surface: faster than 2 m/s either way is 2 m/s; a dry face stands.
  const std::array<float, 4> depth = {1, 1, 1, 0}, pressure = {}, height = {};
  std::array<float, 4> velocity = {5, -5, 0.09f, 1};
  finish_row(2, {depth.data(), pressure.data(), height.data(), height.data()}, 1, 4,
             velocity.data());
  EXPECT_EQ(velocity, (std::array<float, 4>{2, -2, 0.09f, 0}));
}

/// What stand_row leaves of a row of velocities among those beside it, if the other component is as
/// around it (first the nodes on one side: before, two in the middle, after), and 0.1 m/s is slow.
std::array<float, 4> left_standing(const std::array<std::array<float, 4>, 3>& beside,
                                   const std::array<std::array<float, 4>, 8>& around) {
  std::array<float, 4> out{};
  const auto at = [&](std::size_t k) { return around[k].data(); };
  stand_row(0.09999f, {beside[1].data(), beside[0].data(), beside[2].data()},
            {{at(0), at(1), at(2), at(3)}, {at(4), at(5), at(6), at(7)}}, 4, out.data());
  return out;
}

TEST(StandRow, PaintStandsThatIsSlowInAllDirections) {
  // The other component is (0.06 + 3 x 0.2 + 3 x 0.18 + 0.08) / 16 = 0.08 m/s, less by 0.005 in the
  // second column, and 0 in the third, for its sides cancel.
  const std::array<float, 4> along = {0.06f, -0.06f, 0.06f, 0.1f};
  EXPECT_EQ(left_standing({along, along, along}, {std::array{0.06f, 0.06f, 0.06f, 0.0f},
                                                  {0.2f, 0.2f, 0.2f, 0},
                                                  {0.18f, 0.18f, 0.18f, 0},
                                                  {0.08f, 0.0f, 0.08f, 0},
                                                  {0, 0, -0.06f, 0},
                                                  {0, 0, -0.2f, 0},
                                                  {0, 0, -0.18f, 0},
                                                  {0, 0, -0.08f, 0}}),
            (std::array<float, 4>{0.06f, 0, 0, 0.1f}));
}

TEST(StandRow, PaintRunsOrStandsWithThatBesideIt) {
  // 0.08 m/s between 0.12 and 0.12, and between 0.12 and 0.11; 0.12 between 0.08 and 0.07 m/s; and
  // 0.2 m/s, which is more than paint beside it can hold, though it runs the other way.
  EXPECT_EQ(left_standing({std::array{0.12f, 0.12f, 0.08f, -0.1f},
                           {0.08f, 0.08f, 0.12f, 0.2f},
                           {0.12f, 0.11f, 0.07f, -0.1f}},
                          {}),
            (std::array<float, 4>{0.08f, 0, 0, 0.2f}));
}

TEST(HeightRhsRow, LosesWhatFlowsOutThroughEachFaceInItsOwnCells) {
  // Through the right face 3 x 4, the left 1 x 2, the lower 5 x 6, the upper 7 x 2; dt / dx = 1/8,
  // dt / dy = 1/4: 100 - (12 - 2) / 8 - (30 - 14) / 4.
  const std::array<float, 2> depth_x = {1, 3}, velocity_x = {2, 4};
  const float above[2] = {7, 2}, below[2] = {5, 6}, height = 100;
  float rhs = 0;
  height_rhs_row(
      {depth_x.data() + 1, velocity_x.data() + 1, &above[0], &above[1], &below[0], &below[1]},
      &height, 0.125f, 0.25f, 1, &rhs);
  EXPECT_EQ(rhs, 94.75f);
}

}  // namespace
}  // namespace pentimento::conservative

#include "core/fluid/conservative/contact_line.h"

#include <gtest/gtest.h>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

constexpr float kHeld = 0.0025f;  // e
constexpr float kReach = 0.004f;
constexpr float kCell = 0.001f;

// What is left of a friction of 1 on the face between (x, y) and the cell below.
float left_below(const Field<float>& depth_m, int x, int y) {
  float friction = 1;
  ContactLine(kHeld, kReach, kCell, kCell).pin_row(depth_m, Axis::kY, x, y, 1, &friction);
  return friction;
}

// Film of `depth_m` in the upper half of 32 x 32 cells, 4 columns in the middle 4 cells longer
// (`step` 4) or shorter (-4).
Field<float> film(float depth_m, int step) {
  Field<float> f(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const bool middle = x >= 14 && x < 18;
      f(x, y) = y < 16 + (middle ? step : 0) ? depth_m : 0.0f;
    }
  return f;
}

TEST(ContactLine, HoldsAStraightEdgeUntilItIsDeepEnough) {
  EXPECT_EQ(left_below(film(0.99f * kHeld, 0), 16, 15), 0);
  // 1 - 1/4; the mean is a sum of 50 taps, each rounded to 6e-8 of it.
  EXPECT_NEAR(left_below(film(2 * kHeld, 0), 16, 15), 0.75f, 3e-6f);
  EXPECT_EQ(left_below(film(2 * kHeld, 0), 16, 14), 1) << "inside the film";
  EXPECT_EQ(left_below(film(2 * kHeld, 0), 16, 20), 1) << "on bare canvas";
}

TEST(ContactLine, HoldsATipMoreAndANotchLess) {
  const float straight = left_below(film(2 * kHeld, 0), 16, 15);
  EXPECT_LT(left_below(film(2 * kHeld, 4), 16, 19), straight);
  EXPECT_GT(left_below(film(2 * kHeld, -4), 16, 11), straight);
}

TEST(ContactLine, SeesTheSameOnFinerCells) {
  Field<float> fine(64, 64);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x) fine(x, y) = 1.5f * kHeld;
  float friction = 1;
  ContactLine(kHeld, kReach, kCell / 2, kCell / 2).pin_row(fine, Axis::kY, 32, 31, 1, &friction);
  EXPECT_NEAR(friction, left_below(film(1.5f * kHeld, 0), 16, 15), 3e-6f);
}

TEST(ContactLine, CellsWiderThanTheReachStillSeeTheirOwn) {
  Field<float> coarse(8, 8);
  for (int x = 0; x < 8; ++x)
    for (int y = 0; y < 4; ++y) coarse(x, y) = 2 * kHeld;
  float friction = 1;
  ContactLine(kHeld, kReach, 0.1f, 0.1f).pin_row(coarse, Axis::kY, 4, 3, 1, &friction);
  EXPECT_FLOAT_EQ(friction, 0.75f);
}

TEST(ContactLine, SumsInTheSameOrderNearTheSidesOfTheCanvas) {
  // A rough film of 40 x 40 cells, and the part of it that a face at (20, 20) can see with no cell
  // to spare, so that what is read around it ends at the sides of the canvas.
  const auto rough = [](int x, int y) {
    return y > 20 ? 0.0f : kHeld * (1.3f + std::sin(static_cast<float>(x * 7 + y * y)));
  };
  const auto pinned = [&](Axis axis, int left, int top, int right, int bottom) {
    Field<float> f(right - left, bottom - top);
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        f(x - left, y - top) = axis == Axis::kY ? rough(x, y) : rough(y, x);
    float friction = 1;
    ContactLine(kHeld, kReach, kCell, kCell).pin_row(f, axis, 20 - left, 20 - top, 1, &friction);
    return friction;
  };
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    const float far = pinned(axis, 0, 0, 40, 40);
    EXPECT_GT(far, 0.0f);
    EXPECT_LT(far, 1.0f);
    EXPECT_EQ(pinned(axis, 17, 17, 25, 25), far);
    EXPECT_EQ(pinned(axis, 17, 0, 40, 40), far);
    EXPECT_EQ(pinned(axis, 0, 0, 25, 25), far);
  }
}

TEST(ContactLine, DoesNotCountWhatLiesBeyondASideOfTheCanvas) {
  // The film ends three columns to the left of the right side, where nothing of it lies beyond;
  // then as near to the left side.
  Field<float> right(32, 32), left(32, 32);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x)
      right(x, y) = left(31 - x, y) = kHeld * (1 + 0.02f * static_cast<float>(x));
  for (int from_side = 0; from_side < 6; ++from_side)
    EXPECT_NEAR(left_below(right, 31 - from_side, 15), left_below(left, from_side, 15), 3e-6f)
        << from_side;
}

TEST(ContactLine, PinsEveryEdgeOfALongRow) {
  Field<float> stripes(1000, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 1000; ++x) stripes(x, y) = x / 50 % 2 == 0 ? kHeld : 0.0f;
  std::vector<float> friction(999, 1.0f);
  ContactLine(kHeld, kReach, kCell, kCell).pin_row(stripes, Axis::kX, 0, 16, 999, friction.data());
  for (int x = 0; x < 999; ++x)
    EXPECT_EQ(friction[static_cast<std::size_t>(x)] < 1, x % 50 == 49) << x;
}

TEST(ContactLine, LeavesAShallowPuddleAsItIs) {
  Basin b({64, 64, 0.064, 0.064});
  b.fill_depth([](int x, int y) { return x > 16 && x < 48 && y > 16 && y < 48 ? 0.002f : 0.0f; });
  b.step();  // rounds to quanta
  Basin same({64, 64, 0.064, 0.064});
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) same.state.depth_m(x, y) = b.state.depth_m(x, y);
  b.steps(20);
  EXPECT_TRUE(same_bits(b.state.depth_m, same.state.depth_m));
  EXPECT_EQ(b.scheme.awake_share(), 0);
}

TEST(ContactLine, AShallowPuddleRoundsItsEdgeAndKeepsItsOutline) {
  Basin b({64, 64, 0.064, 0.064});
  b.fill_depth([](int x, int y) { return x > 16 && x < 48 && y > 16 && y < 48 ? 0.0008f : 0.0f; });
  b.steps(45 * 20);
  EXPECT_EQ(b.scheme.awake_share(), 0) << "at rest within twenty seconds";
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      EXPECT_EQ(b.state.depth_m(x, y) > 0, x > 16 && x < 48 && y > 16 && y < 48) << x << ' ' << y;
  EXPECT_LT(b.state.depth_m(17, 32), 0.6f * b.state.depth_m(20, 32));
  EXPECT_LT(b.state.depth_m(32, 47), 0.6f * b.state.depth_m(32, 44));
}

TEST(ContactLine, BringsAPuddleToRestAtItsDepth) {
  Basin b({96, 96, 0.096, 0.096});
  b.fill_depth([](int x, int y) { return x > 32 && x < 64 && y > 32 && y < 64 ? 0.008f : 0.0f; });
  b.steps(45 * 60);
  EXPECT_EQ(b.scheme.awake_share(), 0) << "at rest within a minute";
  int wet = 0;
  for (int y = 0; y < 96; ++y)
    for (int x = 0; x < 96; ++x) wet += b.state.depth_m(x, y) > 0.02f * kHeld ? 1 : 0;
  const double mean = total(b.state.depth_m) / wet;
  EXPECT_GT(mean, static_cast<double>(kHeld));
  EXPECT_LT(mean, 1.5 * static_cast<double>(kHeld))
      << "the rim is bent and the slowest paint stands";
}

TEST(ContactLine, AWashComesDownInDrips) {
  // 30 mm of a wash, 2 mm deep give or take a tenth, on a canvas 75 degrees steep.
  constexpr int kSide = 128;
  Basin b({kSide, kSide, 0.128, 0.128});
  b.model.friction_viscosity_floor_m2_s = 5e-4f;
  b.fill_depth([](int x, int y) {
    const float grain = static_cast<float>(x * 37 % 11) / 10 - 0.5f;
    return y >= 10 && y < 40 ? 0.002f + 0.0004f * grain : 0.0f;
  });
  b.gravity_m_s2 = {0, -9.5f, 2.5f};
  b.steps(200);
  // Across the drips, 60 mm below the wash.
  int drips = 0, wet = 0;
  for (int x = 1; x < kSide; ++x) {
    const bool here = b.state.depth_m(x, 100) > 0;
    wet += here ? 1 : 0;
    drips += here && !(b.state.depth_m(x - 1, 100) > 0) ? 1 : 0;
  }
  EXPECT_LE(drips, 9) << "surface tension joins those of the grain, one for each 11 mm";
  EXPECT_GE(drips, 3);
  EXPECT_GE(wet, 3 * drips) << "none is a thread of a cell or two";
  EXPECT_LE(wet, kSide / 2) << "bare canvas between them";
}

}  // namespace
}  // namespace pentimento::conservative

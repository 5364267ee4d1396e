#include "core/fluid/conservative/conservative_scheme.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/tiles/quantum.h"
#include "tests/core/fluid/analytic_case.h"
#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {

/// What a step's viscosity leaves of a shear wave, half a wave over the canvas: along x of v, or
/// along y of u. Cells of 1 mm by 2 mm.
double shear_left(Axis axis) {
  constexpr int kCells = 32;
  Basin b({kCells, kCells, kCells * 0.001, kCells * 0.002});
  b.model = ideal_fluid(0.005);
  b.model.nu_min_m2_s = b.model.nu_max_m2_s = 1e-4f;
  b.model.viscosity_cycles = 20;
  b.fill_depth([](int, int) { return 0.005f; });
  b.gravity_m_s2 = {0, 0, 0};
  b.dt_s = 0.01f;
  const auto wave = [&](int i) {
    return static_cast<float>(std::cos(std::numbers::pi * (i + 0.5) / kCells));
  };
  for (int y = 0; y < kCells; ++y)
    for (int x = 0; x < kCells; ++x) {
      if (axis == Axis::kX && y + 1 < kCells) b.state.velocity_y_m_s(x, y) = 1e-5f * wave(x);
      if (axis == Axis::kY && x + 1 < kCells) b.state.velocity_x_m_s(x, y) = 1e-5f * wave(y);
    }
  b.step();
  const float left = axis == Axis::kX ? b.state.velocity_y_m_s(0, kCells / 2)
                                      : b.state.velocity_x_m_s(kCells / 2, 0);
  return static_cast<double>(left / (1e-5f * wave(0)));
}

TEST(ConservativeScheme, ViscosityCountsEachAxisByItsOwnCells) {
  // Backward Euler: 1 / (1 + nu dt k^2), k^2 = (2 / d sin(pi / 2n))^2 for half a wave over n cells.
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    const double d = axis == Axis::kX ? 0.001 : 0.002;
    const double k = 2 / d * std::sin(std::numbers::pi / 64);
    // A wave that is carried along with itself by 1e-4 of a cell, and the solver's rest.
    EXPECT_NEAR(shear_left(axis), 1 / (1 + 1e-4 * 0.01 * k * k), 2e-5);
  }
}

TEST(ConservativeScheme, SlopesCountEachAxisByItsOwnCells) {
  // A film of 5 mm, 1 um higher from cell to cell along x, 4 um along y, on cells of 1 mm by 2 mm:
  // slopes of 1/1000 and 1/500. A step so short that the height stays: u = -dt g slope.
  Basin b({32, 32, 0.032, 0.064});
  b.model = ideal_fluid(0.005);
  b.dt_s = 1e-4f;
  b.fill_depth([](int x, int y) {
    return 0.005f + 1e-6f * static_cast<float>(x) + 4e-6f * static_cast<float>(y);
  });
  b.step();
  // Depths are whole quanta of 6e-9: 0.6 % of a micrometre.
  EXPECT_NEAR(b.state.velocity_x_m_s(16, 16) / (-1e-4f * 9.81f * 0.001f), 1, 0.01f);
  EXPECT_NEAR(b.state.velocity_y_m_s(16, 16) / (-1e-4f * 9.81f * 0.002f), 1, 0.01f);
}

/// The velocity that one step of 0.1 ms without gravity gives a film, 1 um higher from cell to cell
/// of 1 mm, at a face whose deeper cell is `deep_frac` of max_medium, 5 mm.
float pushed_by_crowding(float deep_frac) {
  Basin b({32, 32, 0.032, 0.032});
  b.model = ideal_fluid(0.005);
  b.model.max_medium_m = 0.005f;
  b.gravity_m_s2 = {0, 0, 0};
  b.dt_s = 1e-4f;
  b.fill_depth([&](int x, int) {
    return deep_frac * b.model.max_medium_m + 1e-6f * static_cast<float>(x - 17);
  });
  b.step();
  return b.state.velocity_x_m_s(16, 16);
}

TEST(ConservativeScheme, PaintOverMaxMediumPushesBack) {
  // Nothing while the canvas can carry it. Then 200 m/s^2 at a fifth over it, half at a tenth:
  // u = -dt crowding slope.
  EXPECT_EQ(pushed_by_crowding(0.98f), 0);
  // Depths are whole quanta, less than 1 % of a micrometre.
  EXPECT_NEAR(pushed_by_crowding(1.1f) / (-1e-4f * 100 * 0.001f), 1, 0.01f);
}

/// A blob that runs down an uneven canvas of cells twice as long as wide; `turned`: with x and y
/// exchanged, and so the order of the axes.
Basin blob(bool turned) {
  const CanvasGeometry upright{48, 40, 0.048, 0.08}, lying{40, 48, 0.08, 0.048};
  Basin b(turned ? lying : upright);
  b.gravity_m_s2 = turned ? Vec3f{-4, 2, 9} : Vec3f{2, -4, 9};
  b.state.step = turned ? 1 : 0;
  b.model.sleep_tile_m = 1;  // one tile
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 48; ++x) {
      const float fx = static_cast<float>(x - 22) / 12, fy = static_cast<float>(y - 17) / 10;
      const float r = fx * fx + 0.6f * fx * fy + fy * fy;
      const int i = turned ? y : x, j = turned ? x : y;
      b.state.base_m(i, j) = 2e-4f * static_cast<float>((x * 5 + y * 3) % 4);
      if (r >= 1) continue;
      b.state.depth_m(i, j) = 0.002f + 0.004f * (1 - r);
      b.state.channel(0, 0)(i, j) = 0.01f * (1 - r);
    }
  return b;
}

/// Largest difference between a plane and another one, turned, over the first one's largest value.
double difference(const Field<float>& upright, const Field<float>& lying) {
  double most = 0, off = 0;
  for (int y = 0; y < upright.height(); ++y)
    for (int x = 0; x < upright.width(); ++x) {
      const double value = static_cast<double>(upright(x, y));
      most = std::max(most, std::abs(value));
      off = std::max(off, std::abs(value - static_cast<double>(lying(y, x))));
    }
  return off / most;
}

TEST(ConservativeScheme, ATurnedCanvasFlowsAlikeTurned) {
  Basin upright = blob(false), lying = blob(true);
  upright.steps(6);
  lying.steps(6);
  // Sums of four round differently when turned, 1e-7 of a height of 1 cm; slopes of thin films at
  // the edge make more of it.
  EXPECT_LT(difference(upright.state.depth_m, lying.state.depth_m), 1e-4);
  EXPECT_LT(difference(upright.state.velocity_x_m_s, lying.state.velocity_y_m_s), 1e-3);
  EXPECT_LT(difference(upright.state.velocity_y_m_s, lying.state.velocity_x_m_s), 1e-3);
  // Pigments that move are whole quanta, and a step may round them to the next one.
  const Field<float>& amount = upright.state.channel(0, 0);
  EXPECT_LE(difference(amount, lying.state.channel(0, 0)),
            6 * static_cast<double>(quantum_for(upright.model.max_pigment) / highest(amount)));
}

TEST(ConservativeScheme, ABrushPushesOnceInAStepCutIntoParts) {
  // A square of paint at rest under a push of 2 mm in x and -1 mm in y everywhere around it, and in
  // a far corner a drop that falls five cells in this step, which cuts it into five parts. Depth
  // moves with half the push (advection.h): one cell of 1 mm, and a quarter of one of 2 mm.
  Basin b({96, 96, 0.096, 0.192});
  b.gravity_m_s2 = {0, 0, 0};
  b.model.surface_tension_N_m = 0;
  b.model.front_depth_m = 0;
  for (int y = 20; y < 40; ++y)
    for (int x = 20; x < 40; ++x) b.state.depth_m(x, y) = 0.01f;
  for (int y = 10; y < 50; ++y)
    for (int x = 10; x < 50; ++x) {
      b.contact.push_x_m(x, y) = 0.002f;
      b.contact.push_y_m(x, y) = -0.001f;
    }
  b.contact.touch(10, 50, 10, 50);
  for (int y = 80; y < 84; ++y)
    for (int x = 80; x < 84; ++x) {
      b.state.depth_m(x, y) = 0.01f;
      b.state.velocity_x_m_s(x, y) = 5 * 0.001f / b.dt_s;
    }
  b.step();
  double mass = 0, moment_x = 0, moment_y = 0;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const double depth = static_cast<double>(b.state.depth_m(x, y));
      mass += depth;
      moment_x += depth * x;
      moment_y += depth * y;
    }
  // Amounts are rounded to quanta of 6e-9 m in cells of 0.01 m.
  EXPECT_NEAR(moment_x / mass, 29.5 + 1, 1e-4);
  EXPECT_NEAR(moment_y / mass, 29.5 - 0.25, 1e-4);
}

}  // namespace
}  // namespace pentimento::conservative

// Films under surface tension, against the rates of linear theory: W. Orchard, "On surface
// levelling in viscous liquids and gels", Appl. Sci. Res. A 11 (1962) 451-464.

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "core/canvas/cell_box.h"
#include "core/fluid/conservative/conservative_scheme.h"
#include "tests/core/fluid/analytic_case.h"
#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {
namespace {
constexpr double kNu = 1e-3;  // m^2/s
constexpr int kAcross = 4;    // cells across the wave

/// A film that one wave after the other runs along: `cells` of `cell_m` along the axis, `across_m`
/// across it.
struct Film {
  Axis axis = Axis::kX;
  int cells = 64;
  double cell_m = 0.001;
  double across_m = 0.002;
  double depth_m = 0.001;
  double gravity_z_m_s2 = 0;
  double step_s = 1.0 / 45;

  double length_m() const { return cells * cell_m; }
  double wave_number(int halves) const { return std::numbers::pi * halves / length_m(); }
  CanvasGeometry geometry() const {
    const double wide = across_m * kAcross;
    if (axis == Axis::kX) return {cells, kAcross, length_m(), wide};
    return {kAcross, cells, wide, length_m()};
  }
  Basin basin() const {
    Basin b(geometry());
    b.model = ideal_fluid(depth_m);
    b.model.surface_tension_N_m = Model{}.surface_tension_N_m;
    b.model.friction_viscosity_floor_m2_s = static_cast<float>(kNu);
    b.model.bed_friction = 1;
    b.model.viscosity_cycles = b.model.height_cycles = 6;
    b.gravity_m_s2 = {0, 0, static_cast<float>(gravity_z_m_s2)};
    b.dt_s = static_cast<float>(step_s);
    return b;
  }
  /// Amplitude of the wave of so many half lengths, in metres.
  double amplitude_m(const Basin& b, int halves) const {
    double sum = 0;
    for (int i = 0; i < cells; ++i) {
      const float d = axis == Axis::kX ? b.state.depth_m(i, 1) : b.state.depth_m(1, i);
      sum += static_cast<double>(d) * std::cos(std::numbers::pi * halves * (i + 0.5) / cells);
    }
    return 2 * sum / cells;
  }
  /// Growth of such a wave, 1/s, between 1 s and `end_s`.
  double growth_per_s(int halves, double end_s) const {
    Basin b = basin();
    b.fill_depth([&](int x, int y) {
      const int i = axis == Axis::kX ? x : y;
      const double wave = std::cos(std::numbers::pi * halves * (i + 0.5) / cells);
      return static_cast<float>(depth_m * (1 + 0.02 * wave));
    });
    const int first = static_cast<int>(1 / step_s + 0.5);
    const int steps = static_cast<int>((end_s - 1) / step_s + 0.5);
    b.steps(first);
    const double before = amplitude_m(b, halves);
    b.steps(steps);
    return std::log(amplitude_m(b, halves) / before) / (steps * step_s);
  }
  /// The rate by theory: depth^3/(3 nu) q^2 (-g - s q^2), less what viscosity along the film costs.
  double rate_per_s(int halves) const {
    const double q = wave_number(halves), s = static_cast<double>(Model{}.tension_m3_s2());
    const double thin = depth_m * depth_m * depth_m / (3 * kNu);
    return -thin * q * q * (gravity_z_m_s2 + s * q * q) / (1 + q * q * depth_m * depth_m / 3);
  }
};

TEST(SurfaceTension, ARippleDecaysAtOrchardsRate) {
  // Along either axis, on cells that are not square. 2 %: the wave has 32 cells (0.3 %), its height
  // is a fiftieth of the depth, and the step is 1/45 s.
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    const Film film{.axis = axis};
    EXPECT_NEAR(film.growth_per_s(4, 11) / film.rate_per_s(4), 1, 0.02);
  }
}

TEST(SurfaceTension, ADeepFilmDecaysAtOrchardsRateInTheLimit) {
  // 3 mm: the implicit half holds its shortest waves and lags (kGoesOn), in proportion to the step.
  // On cells twice as long as wide it has less tension (conservative_scheme.cpp: stiffest).
  Film film{.across_m = 0.001, .depth_m = 0.003};
  EXPECT_NEAR(film.growth_per_s(4, 3) / film.rate_per_s(4), 1, 0.13);
  film.step_s /= 8;
  EXPECT_NEAR(film.growth_per_s(4, 3) / film.rate_per_s(4), 1, 0.03);
}

TEST(SurfaceTension, GravityAndTensionAdd) {
  const Film film{.gravity_z_m_s2 = 2.5};
  EXPECT_NEAR(film.growth_per_s(4, 6) / film.rate_per_s(4), 1, 0.02);
}

TEST(SurfaceTension, AHangingFilmGathersAtTheCapillaryWavelength) {
  // 2 pi sqrt(2) sqrt(s / g) = 16.5 mm. On 165 mm that is 20 halves.
  const Film film{.cells = 165, .gravity_z_m_s2 = -9.81};
  const double s = static_cast<double>(Model{}.tension_m3_s2());
  const double fastest_m = 2 * std::numbers::pi * std::sqrt(2 * s / 9.81);
  EXPECT_NEAR(fastest_m, 0.0165, 1e-4);
  int best = 0;
  double most = 0;
  for (int halves = 4; halves <= 36; halves += 2) {
    const double growth = film.growth_per_s(halves, 3);
    if (growth > most) best = halves, most = growth;
    // Long waves grow, waves shorter than 2 pi sqrt(s / g) = 11.6 mm (28 halves) decay.
    if (halves != 28) {
      EXPECT_EQ(growth > 0, halves < 28) << halves;
    }
  }
  EXPECT_NEAR(2 * film.length_m() / best / fastest_m, 1, 0.1);
  EXPECT_NEAR(most / film.rate_per_s(20), 1, 0.05);
}

TEST(SurfaceTension, TheRateConvergesWithTheGrid) {
  // A wave of 8, 16 and 32 cells of a film so thin that nothing is held: second order, less what
  // the wave's height, a fiftieth of the depth, adds to all three.
  double error[3];
  for (int n = 0; n < 3; ++n) {
    const Film film{.cells = 8 << n, .cell_m = 0.016 / (8 << n), .depth_m = 2e-4, .step_s = 0.01};
    error[n] = std::abs(film.growth_per_s(2, 11) / film.rate_per_s(2) - 1);
  }
  EXPECT_GT(error[0] / error[1], 3);
  EXPECT_GT(error[1] / error[2], 3);
}

TEST(SurfaceTension, AStripWithHeldEdgesRestsAsAParabola) {
  // Without gravity the pressure is even, so the curvature is: 3/2 d (1 - (x / a)^2), a = 4 mm. Its
  // edges lean by 0.75, less than the contact slope. 6 %: the strip has 8 cells, and at its edges
  // the curvature is of the first order.
  for (const Axis axis : {Axis::kX, Axis::kY}) {
    Film film{.axis = axis, .cells = 24};
    Basin b = film.basin();
    b.model.front_depth_m = Model{}.front_depth_m;
    const auto along = [&](int x, int y) { return axis == Axis::kX ? x : y; };
    b.fill_depth([&](int x, int y) {
      const int i = along(x, y);
      return i >= 8 && i < 16 ? static_cast<float>(film.depth_m) : 0.0f;
    });
    b.steps(45 * 30);
    for (int i = 0; i < 24; ++i) {
      const double x = (i + 0.5 - 12) / 4;
      const double expected = std::max(0.0, 1.5 * film.depth_m * (1 - x * x));
      const float depth = axis == Axis::kX ? b.state.depth_m(i, 1) : b.state.depth_m(1, i);
      EXPECT_NEAR(depth, expected, 0.06 * film.depth_m) << i;
    }
  }
}

TEST(SurfaceTension, TheOuterCornersOfAStaircaseDrain) {
  // The edge of a film at 45 degrees, held: a corner has two edges, and holds some 0.45 of
  // what the next cell holds. Without a slope at edges it would hold as much.
  Basin b({24, 24, 0.024, 0.024});
  b.gravity_m_s2 = {0, 0, 0};
  b.fill_depth([](int x, int y) { return x + y <= 24 ? 0.001f : 0.0f; });
  b.steps(45 * 10);
  for (int x = 8; x < 16; ++x) {
    EXPECT_GT(b.state.depth_m(x, 24 - x), 0) << x;
    EXPECT_LT(b.state.depth_m(x, 24 - x), 0.6f * b.state.depth_m(x, 23 - x)) << x;
    EXPECT_EQ(b.state.depth_m(x, 25 - x), 0) << x;
  }
}

TEST(SurfaceTension, NoWaveOfNoFilmGrows) {
  // From films that flow at once to films that hardly do, with steps from 1 ms to 1 s: what begins
  // as noise on an upright canvas ends flatter, but for a quantum of depth (1.5e-8 m).
  for (const float depth_m : {2e-4f, 1e-3f, 5e-3f, 2e-2f})
    for (const float step_s : {1e-3f, 1.0f / 45, 1.0f}) {
      Basin b({32, 32, 0.032, 0.048});
      b.model.front_depth_m = 0;
      b.model.velocity_threshold_m_s = 0;
      b.model.gravity_cutoff_frac = 0;
      b.gravity_m_s2 = {0, 0, 0};
      b.dt_s = step_s;
      unsigned seed = 7;
      b.fill_depth([&](int, int) {
        seed = seed * 1664525u + 1013904223u;
        return depth_m * (0.9f + 0.2f * static_cast<float>(seed >> 8) / (1 << 24));
      });
      const auto spread = [&] { return highest(b.state.depth_m) - lowest(b.state.depth_m); };
      const float before = spread();
      float most = 0;
      for (int k = 0; k < 100; ++k) {
        b.step();
        most = std::max(most, spread());
      }
      EXPECT_LT(most, 1.05f * before) << depth_m << " m, steps of " << step_s << " s";
      EXPECT_LT(spread(), before + 2e-8f) << depth_m << " m, steps of " << step_s << " s";
    }
}

TEST(SurfaceTension, WithoutItGravityOffTheCanvasCountsAsNone) {
  Basin hanging({32, 32, 0.032, 0.032}), weightless({32, 32, 0.032, 0.032});
  for (Basin* b : {&hanging, &weightless}) {
    b->model.surface_tension_N_m = 0;
    b->fill_depth([](int x, int y) { return 0.002f + 1e-4f * static_cast<float>((x * y) % 3); });
  }
  hanging.gravity_m_s2 = {1, 2, -9.81f};
  weightless.gravity_m_s2 = {1, 2, 0};
  hanging.steps(5);
  weightless.steps(5);
  EXPECT_TRUE(same_bits(hanging.state.depth_m, weightless.state.depth_m));
}

TEST(SurfaceTension, APuddleOnAnUprightCanvasLiesAsAWedge) {
  // 10 mm of paint, half of it runny enough to wave, against the lower wall. Gravity along the
  // canvas and the gravity that it sags under are the same, so its surface leans by 45 degrees, as
  // deep at the wall as it is high; where its surface carries it, less deep. Without sagging it
  // broke up. Paint as runny and deep as this goes on to wave, so this is its mean over 15 s.
  Basin b({40, 40, 0.04, 0.04});
  b.gravity_m_s2 = {0, -9.81f, 0};
  b.fill_depth([](int, int y) { return y >= 20 ? 0.01f : 0.0f; });
  const double before = total(b.state.depth_m);
  b.steps(45 * 5);
  constexpr int kSteps = 45 * 15;
  std::array<double, 40> middle{}, quarter{};
  for (int k = 0; k < kSteps; ++k) {
    b.step();
    for (int y = 0; y < 40; ++y) {
      middle[static_cast<std::size_t>(y)] += static_cast<double>(b.state.depth_m(20, y)) / kSteps;
      quarter[static_cast<std::size_t>(y)] += static_cast<double>(b.state.depth_m(10, y)) / kSteps;
    }
  }
  EXPECT_EQ(total(b.state.depth_m), before);
  // 20 mm of 10 mm: a wedge of 20 mm, which is less deep at its other end.
  EXPECT_NEAR(middle[39], 0.02, 0.002);
  for (std::size_t y = 25; y < 39; ++y) {
    EXPECT_LT(middle[y], middle[y + 1]) << y;
    EXPECT_NEAR(middle[y], quarter[y], 5e-4) << y;  // what the waves leave of the mean
  }
}

TEST(SurfaceTension, ADropUnderACeilingHangsNoDeeperThanItCan) {
  // Gravity off the canvas and the gravity that a heap sags under are equal halfway between 3.7 and
  // 7.4 mm; where the drop is that deep they hold each other. 1 mm more: tension and swing.
  Basin b({40, 40, 0.04, 0.04});
  b.gravity_m_s2 = {0, 0, -9.81f};
  b.fill_depth([](int x, int y) {
    const int dx = x - 20, dy = y - 20;
    return dx * dx + dy * dy < 100 ? 0.006f : 0.002f;
  });
  b.steps(45 * 20);
  EXPECT_GT(b.statistic("max_depth_m"), 0.005) << "it hangs";
  EXPECT_LT(b.statistic("max_depth_m"), 0.0085);
}

}  // namespace
}  // namespace pentimento::conservative

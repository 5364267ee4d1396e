// R6 and R9 against the amplitudes of a plane wave worked out by hand.

#include <gtest/gtest.h>

#include "core/fluid/paper/height_sweep.h"
#include "core/fluid/paper/height_system.h"
#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

constexpr float kAmplitude_m = 1e-4f;
constexpr double kPi = 3.14159265358979323846;

/// Amplitude left of a cosine along x, `wavelength` cells long, on 0.5 mm of fluid after `sweeps`.
/// The wave mirrors at the edges, so the closed canvas carries it undisturbed.
double amplitude_after(int wavelength, int sweeps) {
  TestCanvas canvas(2 * wavelength, 4);
  canvas.model.gravity_cutoff_frac = 0;
  canvas.flood(5e-4f, 0);
  const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                     canvas.contact, canvas.amount,  canvas.threads};
  const StepConstants k = make_step_constants(canvas.state.geometry, in);
  const int width = 2 * wavelength;
  Planes planes = make_planes(width, 4, 2);
  planes.mobility_frac.fill(1);
  const auto wave = [&](int x) { return std::cos(2 * kPi * (x + 0.5) / wavelength); };
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < width; ++x)
      planes.height_m[0](x, y) = planes.system.centre(x, y) =
          5e-4f + kAmplitude_m * static_cast<float>(wave(x));
  for (int y = 0; y < 4; ++y) build_height_system_row(k, canvas.state, y, {0, width}, planes);
  for (int s = 0; s < sweeps; ++s)
    for (int y = 0; y < 4; ++y)
      sweep_height_row(planes.system, planes.height_m[static_cast<std::size_t>(s % 2)], y,
                       {0, width}, planes.height_m[static_cast<std::size_t>((s + 1) % 2)].row(y));
  double projected = 0, norm = 0;
  for (int x = 0; x < width; ++x) {
    projected += wave(x) * planes.height_m[static_cast<std::size_t>(sweeps % 2)](x, 1);
    norm += wave(x) * wave(x);
  }
  return projected / norm / kAmplitude_m;
}

// 2e-6: the height is a float of 5e-4, rounded to 3e-11, that is 3e-7 of the amplitude, a few
// times.
constexpr double kRounding = 2e-6;

TEST(HeightSweep, FourSweepsFromTheOldHeightLeaveTheKnownAmplitude) {
  EXPECT_NEAR(amplitude_after(16, 4), 0.8632097567, kRounding);
  EXPECT_NEAR(amplitude_after(64, 4), 0.9907948920, kRounding);
}

TEST(HeightSweep, ConvergesToTheImplicitSolution) {
  EXPECT_NEAR(amplitude_after(16, 300), 0.7211498616, kRounding);
  EXPECT_NEAR(amplitude_after(64, 300), 0.9761235569, kRounding);
}

TEST(HeightSystem, KeepsItsDiagonalDominantOnAnyRelief) {
  TestCanvas canvas(40, 30);
  canvas.roughen(0.05f);
  canvas.pour(0, 0, 40, 15, 6e-4f, 0);
  canvas.pour(0, 15, 40, 30, 0.04f, 0);
  const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                     canvas.contact, canvas.amount,  canvas.threads};
  Planes planes = make_planes(40, 30, 2);
  planes.mobility_frac.fill(1);
  const StepConstants k = make_step_constants(canvas.state.geometry, in);
  for (int y = 0; y < 30; ++y) {
    build_height_system_row(k, canvas.state, y, {0, 40}, planes);
    for (int x = 0; x < 40; ++x) {
      const Stencil& s = planes.system;
      const float sum = std::abs(s.left(x, y)) + std::abs(s.right(x, y)) + std::abs(s.up(x, y)) +
                        std::abs(s.down(x, y));
      EXPECT_LE(sum, 1.000001f) << x << "," << y;  // rounding of five terms
    }
  }
}

TEST(HeightSystem, CountsEachAxisInItsOwnCells) {
  // Cells of 1 mm by 2 mm, dt = 0.1 s, g = 10 m/s^2: G dt^2 = 0.1 m. A film of 1 mm gives
  // G dt^2 d / dx^2 = 100 and 25 along y. The relief rises by 1/10 along x and 1/5 along y:
  // G dt^2 b_x / 2 dx = 5, and 5 along y.
  const CanvasGeometry geometry{3, 3, 0.003, 0.006};
  TestCanvas canvas(geometry);
  canvas.gravity = {0, 0, 10};
  canvas.dt_s = 0.1f;
  canvas.flood(0.001f, 0);
  Planes p = make_planes(3, 3, 1);
  p.mobility_frac.fill(1);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x) {
      canvas.state.base_m(x, y) = 1e-4f * static_cast<float>(x) + 4e-4f * static_cast<float>(y);
      p.u_m_s[0](x, y) = 0.01f * static_cast<float>(x);  // u~_x = 10 and v~_y = 10 1/s
      p.v_m_s[0](x, y) = 0.02f * static_cast<float>(y);
    }
  p.system.centre.fill(0.05f);
  const StepConstants k = make_step_constants(
      geometry,
      {canvas.model, canvas.gravity, canvas.dt_s, canvas.contact, canvas.amount, canvas.threads});
  build_height_system_row(k, canvas.state, 1, {0, 3}, p);
  const float diagonal = 1 + 2 * (100 + 25);
  EXPECT_NEAR(p.system.left(1, 1) * diagonal, 105, 2e-3f);  // a few roundings of a float
  EXPECT_NEAR(p.system.right(1, 1) * diagonal, 95, 2e-3f);
  EXPECT_NEAR(p.system.up(1, 1) * diagonal, 30, 2e-3f);
  EXPECT_NEAR(p.system.down(1, 1) * diagonal, 20, 2e-3f);
  // h~ + dt (u~ b_x + v~ b_y) - dt d (u~_x + v~_y), u~ = 0.01 and v~ = 0.02 m/s in the middle.
  EXPECT_NEAR(p.system.centre(1, 1) * diagonal,
              0.05f + 0.1f * (0.01f * 0.1f + 0.02f * 0.2f) - 0.1f * 0.001f * 20, 1e-7f);
}

TEST(HeightSystem, ConvergingFlowRaisesTheFilm) {
  TestCanvas canvas(5, 3);
  canvas.flood(0.01f, 0);
  canvas.gravity = {0, 0, 0};
  const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                     canvas.contact, canvas.amount,  canvas.threads};
  Planes planes = make_planes(5, 3, 2);
  planes.system.centre.fill(0.01f);
  for (int y = 0; y < 3; ++y) {
    planes.u_m_s[0](1, y) = 0.1f;
    planes.u_m_s[0](3, y) = -0.1f;
  }
  build_height_system_row(make_step_constants(canvas.state.geometry, in), canvas.state, 1, {0, 5},
                          planes);
  // -dt d u_x = 1/45 * 0.01 * 0.2 / (2/1024)
  EXPECT_NEAR(planes.system.centre(2, 1), 0.01 + 0.01 * 0.2 * 512 / 45,
              1e-8);  // a float's rounding
}

}  // namespace
}  // namespace pentimento::paper

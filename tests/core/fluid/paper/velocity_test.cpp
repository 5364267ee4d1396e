// R11, R13, R14, R16, R17 pass by pass.

#include <gtest/gtest.h>

#include "core/fluid/paper/velocity_limits.h"
#include "core/fluid/paper/viscosity.h"
#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

TEST(Viscosity, IsBoundedFarBeyondTheExplicitLimit) {
  const Model model;
  const double dt = 1.0 / 45, dx = 1.0 / 1024, dy = 1.0 / 768;
  const double limit = 1 / (2 * dt * (1 / (dx * dx) + 1 / (dy * dy)));
  EXPECT_NEAR(limit, 1.3733e-5, 5e-10);  // the printed digits
  EXPECT_GT(static_cast<double>(model.nu_max_m2_s) / limit, 728);

  TestCanvas canvas(24, 24);
  const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                     canvas.contact, canvas.amount,  canvas.threads};
  const StepConstants k = make_step_constants(canvas.state.geometry, in);
  Planes p = make_planes(24, 24, 1);
  p.wet.fill(1);
  p.viscosity_m2_s.fill(model.nu_max_m2_s);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) {
      p.u_m_s[0](x, y) = (x + y) % 2 == 0 ? 1.0f : -1.0f;
      p.u_m_s[1](x, y) = p.u_m_s[0](x, y);
    }
  for (int y = 0; y < 24; ++y) build_viscosity_row(k, y, {0, 24}, p);
  for (int sweep = 0; sweep < 50; ++sweep) {
    const std::size_t from = sweep % 2 == 0 ? 1 : 2, to = 3 - from;
    for (int y = 0; y < 24; ++y)
      sweep_viscosity_row(p.system, {p.u_m_s[0], p.v_m_s[0]}, {p.u_m_s[from], p.v_m_s[from]}, y,
                          {0, 24}, p.u_m_s[to].row(y), p.v_m_s[to].row(y));
    EXPECT_TRUE(within(p.u_m_s[to], -1, 1));
  }
}

TEST(Viscosity, DryNeighboursPullNothing) {
  TestCanvas canvas(5, 3);
  const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                     canvas.contact, canvas.amount,  canvas.threads};
  const StepConstants k = make_step_constants(canvas.state.geometry, in);
  Planes p = make_planes(5, 3, 1);
  p.viscosity_m2_s.fill(1e-2f);
  for (int x = 1; x < 4; ++x) {
    p.wet(x, 1) = 1;
    p.u_m_s[0](x, 1) = 0.25f;
  }
  build_viscosity_row(k, 1, {0, 5}, p);
  sweep_viscosity_row(p.system, {p.u_m_s[0], p.v_m_s[0]}, {p.u_m_s[0], p.v_m_s[0]}, 1, {0, 5},
                      p.u_m_s[1].row(1), p.v_m_s[1].row(1));
  for (int x = 1; x < 4; ++x) EXPECT_FLOAT_EQ(p.u_m_s[1](x, 1), 0.25f);
}

TEST(Velocity, SlowPaintStandsAndFastPaintIsCapped) {
  TestCanvas canvas(4, 1);
  const StepInput in{canvas.model,   canvas.gravity, canvas.dt_s,
                     canvas.contact, canvas.amount,  canvas.threads};
  const StepConstants k = make_step_constants(canvas.state.geometry, in);
  float u[4] = {6e-4f, 7e-4f, 3, -1e30f}, v[4] = {7e-4f, 8e-4f, 4, 0};
  u[3] = -1e15f;
  limit_speed_row(k, {0, 4}, u, v);
  EXPECT_EQ(u[0], 0);  // |(6,7)| e-4 = 0.92 mm/s: below the threshold of 1 mm/s
  EXPECT_EQ(v[0], 0);
  EXPECT_EQ(u[1], 7e-4f);  // 1.06 mm/s
  EXPECT_FLOAT_EQ(u[2], 3 * 1.4007f / 5);
  EXPECT_FLOAT_EQ(v[2], 4 * 1.4007f / 5);
  EXPECT_FLOAT_EQ(u[3], -1.4007f);
}

TEST(Velocity, StampedCellsHaveTheBrushVelocityAfterTheStep) {
  TestCanvas canvas(32, 24);
  canvas.flood(0.002f, 0.01f);
  canvas.touch(10, 10, 16, 14, 0.3f, -0.2f);
  EXPECT_TRUE(canvas.step());
  for (int y = 10; y < 14; ++y)
    for (int x = 10; x < 16; ++x) {
      EXPECT_EQ(canvas.state.velocity_x_m_s(x, y), 0.3f);
      EXPECT_EQ(canvas.state.velocity_y_m_s(x, y), -0.2f);
    }
}

TEST(Velocity, NoPaintCrossesTheEdge) {
  TestCanvas canvas(32, 24);
  canvas.flood(0.01f, 0.01f);
  canvas.gravity = {6, -5, 9};
  canvas.touch(0, 0, 6, 24, -0.5f, -0.5f);
  for (int i = 0; i < 10; ++i) {
    canvas.step();
    for (int y = 0; y < 24; ++y) {
      EXPECT_EQ(canvas.state.velocity_x_m_s(0, y), 0);
      EXPECT_EQ(canvas.state.velocity_x_m_s(31, y), 0);
    }
    for (int x = 0; x < 32; ++x) {
      EXPECT_EQ(canvas.state.velocity_y_m_s(x, 0), 0);
      EXPECT_EQ(canvas.state.velocity_y_m_s(x, 23), 0);
    }
  }
}

}  // namespace
}  // namespace pentimento::paper

#include "core/fluid/paper/paper_scheme.h"

#include <gtest/gtest.h>

#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

/// A tilted blob on an uneven canvas of cells twice as long as wide; `turned`: with x and y
/// exchanged.
TestCanvas blob(bool turned) {
  const CanvasGeometry upright{48, 40, 0.048, 0.08}, lying{40, 48, 0.08, 0.048};
  TestCanvas canvas(turned ? lying : upright);
  canvas.gravity = turned ? Vec3f{-4, 2, 9} : Vec3f{2, -4, 9};
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 48; ++x) {
      const float fx = static_cast<float>(x - 22) / 12, fy = static_cast<float>(y - 17) / 10;
      const float r = fx * fx + 0.6f * fx * fy + fy * fy;
      const int i = turned ? y : x, j = turned ? x : y;
      canvas.state.base_m(i, j) = 2e-4f * static_cast<float>((x * 5 + y * 3) % 4);
      if (r >= 1) continue;
      canvas.state.depth_m(i, j) = 0.002f + 0.004f * (1 - r);
      canvas.state.channel(0, 0)(i, j) = 0.03f * (1 - r);
    }
  return canvas;
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

TEST(PaperScheme, ATurnedCanvasFlowsAlikeTurned) {
  TestCanvas upright = blob(false), lying = blob(true);
  upright.steps(4);
  lying.steps(4);
  const CanvasState &a = upright.state, &b = lying.state;
  // Bilinear values round differently along x and along y, by 1e-7, which the steep front blows up.
  EXPECT_LT(difference(a.depth_m, b.depth_m), 1e-4);
  EXPECT_LT(difference(a.velocity_x_m_s, b.velocity_y_m_s), 1e-4);
  EXPECT_LT(difference(a.velocity_y_m_s, b.velocity_x_m_s), 1e-4);
  EXPECT_LT(difference(a.channel(0, 0), b.channel(0, 0)), 1e-4);
}

/// Paint without gravity, residue or cap: it keeps the velocity that it is given.
TestCanvas weightless(const CanvasGeometry& geometry) {
  TestCanvas canvas(geometry, 1, 1);
  canvas.gravity = {0, 0, 0};
  canvas.model.pigment_residue = 0;
  canvas.model.speed_cap_m_s = 0;
  return canvas;
}

TEST(PaperScheme, AFilmSlowerThanACellAStepCarriesItsPigmentAndItsFront) {
  // 0.4 cells a step. The pigment of a single layer goes half as fast (R18): at cell 30 there is
  // what was at 29.8, which is exact for pigment that rises evenly.
  TestCanvas canvas = weightless({64, 12, 0.064, 0.012});
  const float speed = 0.4f * 0.001f / canvas.dt_s;
  canvas.pour(20, 0, 40, 12, 0.01f, 0);
  for (int y = 0; y < 12; ++y)
    for (int x = 20; x < 40; ++x) {
      canvas.state.channel(0, 0)(x, y) = 0.001f * static_cast<float>(x);
      canvas.state.velocity_x_m_s(x, y) = speed;
    }
  canvas.step();
  EXPECT_NEAR(canvas.state.channel(0, 0)(30, 6), 0.0298f, 1e-7f);
  // The first bare cell has the film's velocity, so that the next step brings it 0.4 of the cell
  // beside it.
  EXPECT_NEAR(canvas.state.velocity_x_m_s(40, 6), speed, 1e-6f);
  EXPECT_EQ(canvas.state.velocity_x_m_s(41, 6), 0);
  const float behind_m = canvas.state.depth_m(39, 6);
  canvas.step();
  EXPECT_NEAR(canvas.state.depth_m(40, 6), 0.4f * behind_m, 1e-6f);
}

TEST(PaperScheme, DryPigmentBesideAMovingFilmIsAllThere) {
  // Even pigment on both sides of a film that moves, without medium. Its viscosity drags the cell
  // beside the film along, and what comes there is as much as what goes.
  for (const float direction : {1.0f, -1.0f}) {
    TestCanvas canvas = weightless({64, 12, 0.064, 0.012});
    canvas.pour(0, 0, 64, 12, 0, 0.02f);
    canvas.pour(20, 0, 40, 12, 0.01f, 0.02f);
    for (int y = 0; y < 12; ++y)
      for (int x = 20; x < 40; ++x)
        canvas.state.velocity_x_m_s(x, y) = direction * 0.8f * 0.001f / canvas.dt_s;
    canvas.step();
    for (int x = 0; x < 64; ++x) EXPECT_NEAR(canvas.state.channel(0, 0)(x, 6), 0.02f, 1e-7f) << x;
  }
}

TEST(PaperScheme, AFastFrontReachesAsFarAsItsFilmOnFlatCells) {
  // 3.5 cells a step along y, on cells four times as wide as high: the foremost four cells travel
  // at least three, so the front advances by four (wet_front.h).
  TestCanvas canvas = weightless({12, 64, 0.048, 0.064});
  const float speed = 3.5f * 0.001f / canvas.dt_s;
  canvas.pour(0, 0, 12, 30, 0.01f, 0.01f);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 12; ++x) canvas.state.velocity_y_m_s(x, y) = speed;
  canvas.step();
  for (int y = 30; y < 34; ++y) EXPECT_NEAR(canvas.state.velocity_y_m_s(6, y), speed, 1e-6f) << y;
  EXPECT_EQ(canvas.state.velocity_y_m_s(6, 34), 0);
}

}  // namespace
}  // namespace pentimento::paper

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

TEST(PaperScheme, AFilmThatSlidesMovesWithAllItsPigmentAndItsFront) {
  // A film two cells long that a gust carries 2.5 cells in a step. What waits three cells behind
  // the film, without medium, is as far as what comes in can come from.
  TestCanvas canvas(CanvasGeometry{40, 12, 0.04, 0.012}, 1, 1);
  canvas.gravity = {0, 0, 0};
  canvas.model.pigment_residue = 0;
  canvas.model.speed_cap_m_s = 0;
  canvas.pour(20, 0, 22, 12, 0.01f, 0.02f);
  canvas.pour(15, 0, 20, 12, 0, 0.02f);
  const float speed = 2.5f * 0.001f / canvas.dt_s;
  for (int y = 0; y < 12; ++y)
    for (int x = 20; x < 22; ++x) canvas.state.velocity_x_m_s(x, y) = speed;
  canvas.step();
  for (int x = 14; x < 30; ++x)
    printf("%d d %g u %g p %g\n", x, canvas.state.depth_m(x, 6), canvas.state.velocity_x_m_s(x, 6),
           canvas.state.channel(0, 0)(x, 6));
}

}  // namespace
}  // namespace pentimento::paper

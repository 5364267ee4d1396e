// Whole steps: rest, gravity, fronts.

#include <gtest/gtest.h>

#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

TEST(PaperScheme, ALakeAtRestKeepsItsBits) {
  TestCanvas canvas(48, 36);
  canvas.roughen(0.003f);
  for (int y = 0; y < 36; ++y)
    for (int x = 0; x < 48; ++x) {
      canvas.state.depth_m(x, y) = 0.01f - canvas.state.base_m(x, y);
      canvas.state.channel(0, 0)(x, y) = 0.02f;
    }
  const CanvasState before = copy_of(canvas.state);
  for (int i = 0; i < 50; ++i) EXPECT_FALSE(canvas.step());
  EXPECT_TRUE(same_state(canvas.state, before));
}

TEST(PaperScheme, StiffPaintStandsOnAnyTilt) {
  TestCanvas canvas(32, 24);
  canvas.pour(8, 8, 20, 16, 0.002f, 0.04f);  // theta 20, above beta
  canvas.gravity = {3, -9, 2};
  EXPECT_FALSE(canvas.step());
  canvas.model.phi_scales_lateral = false;  // reading (b) of A7: it slides
  EXPECT_TRUE(canvas.step());
  EXPECT_LT(canvas.state.velocity_x_m_s(14, 12), 0);
}

TEST(PaperScheme, ADryCanvasChangesNothing) {
  TestCanvas canvas(32, 24);
  canvas.roughen(0.001f);
  canvas.gravity = {5, 5, 5};
  EXPECT_FALSE(canvas.step());
}

TEST(PaperScheme, ATiltedUniformFilmGainsTheKnownSpeed) {
  TestCanvas canvas(300, 12);
  canvas.flood(0.01f, 0.1f);  // theta 10: Phi = 1/2
  canvas.gravity = {2, 0, 0};
  canvas.steps(10);
  // 10 dt (1 - Phi) gx; far enough from the edges that their influence has not arrived.
  EXPECT_NEAR(canvas.state.velocity_x_m_s(150, 6), -0.2222222f, 1e-7f);  // printed digits
  EXPECT_EQ(canvas.state.velocity_y_m_s(150, 6), 0);
}

/// Centre of what a plane holds, in rows from the top.
double centre_row(const Field<float>& f) {
  double moment = 0;
  for (int y = 0; y < f.height(); ++y)
    for (int x = 0; x < f.width(); ++x) moment += static_cast<double>(f(x, y)) * y;
  return moment / sum(f);
}

TEST(PaperScheme, ThinPaintOnAnUprightTabletRunsToTheBottom) {
  TestCanvas canvas(48, 192);
  canvas.pour(16, 20, 32, 60, 0.002f, 0.004f);
  canvas.gravity = {0, -9.81f, 0};
  const Field<float>& depth = canvas.state.depth_m;
  const double poured = sum(depth);
  canvas.steps(3);
  EXPECT_GT(canvas.state.velocity_y_m_s(24, 50), 0);
  canvas.steps(4);
  // Free fall by (1 + ... + 6) g dt^2 = 102 mm = 78 rows, from row 39.5. Within 5: the front lags.
  EXPECT_NEAR(centre_row(depth), 117.5, 5);
  // The trace keeps no sum: in these steps it loses 0.43 of the medium, nearly all at the front.
  EXPECT_GT(sum(depth), 0.5 * poured);
  canvas.steps(60);
  EXPECT_GT(centre_row(depth), 170);
  EXPECT_GT(centre_row(canvas.state.channel(0, 0)), 60);  // half as fast, until left behind (R18)
}

TEST(PaperScheme, AFrontFeelsTheGravityOfItsFilm) {
  TestCanvas canvas(64, 192);
  canvas.pour(8, 20, 56, 60, 0.002f, 0.004f);
  canvas.gravity = {0, -5, 0};
  canvas.steps(4);
  const float film = canvas.state.velocity_y_m_s(32, 50);
  int front = 0;
  for (int y = 0; y < 192; ++y)
    if (canvas.state.depth_m(32, y) >= 5e-4f) front = y;
  EXPECT_GT(front, 66);
  EXPECT_NEAR(canvas.state.velocity_y_m_s(32, front), film, 0.2f * film);  // at most a step behind
}

TEST(PaperScheme, FilmsThinnerThanOnePercentFeelNoGravity) {
  TestCanvas canvas(32, 24);
  canvas.pour(8, 8, 20, 16, 4.9e-4f, 0);
  canvas.gravity = {0, -9.81f, 9.81f};
  EXPECT_FALSE(canvas.step());
}

TEST(PaperScheme, FaceDownPaintKeepsItsHeightField) {
  TestCanvas canvas(48, 36);
  canvas.pour(10, 10, 30, 25, 0.005f, 0.005f);
  canvas.gravity = {0, 0, -9.81f};
  EXPECT_FALSE(canvas.step());
}

TEST(PaperScheme, StrokeIdsStay) {
  TestCanvas canvas(48, 36);
  canvas.pour(10, 10, 30, 25, 0.005f, 0.005f);
  canvas.state.stroke(12, 12) = 7;
  canvas.gravity = {0, -5, 5};
  canvas.steps(5);
  EXPECT_EQ(canvas.state.stroke(12, 12), 7u);
  EXPECT_EQ(canvas.state.stroke(12, 30), 0u);
}

TEST(PaperScheme, ComputesOnlyWherePaintIs) {
  TestCanvas canvas(128, 96);
  canvas.pour(60, 40, 68, 48, 0.002f, 0.002f);
  canvas.step();
  EXPECT_EQ(canvas.scheme.statistics()[1].first, "live_frac");
  EXPECT_NEAR(canvas.scheme.statistics()[1].second, 10.0 * 10 / (128 * 96), 1e-12);  // exact count
}

}  // namespace
}  // namespace pentimento::paper

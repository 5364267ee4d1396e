#include "core/fluid/paper/gravity.h"

#include <gtest/gtest.h>

#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

TEST(Gravity, PullsDownTheSlopeOfEachAxisInItsOwnCells) {
  // The surface rises by 0.1 mm from cell to cell along x and by 0.4 mm along y, on cells of 1 mm
  // by 2 mm: slopes of 1/10 and 1/5. A second of 10 m/s^2 gives -1 and -2 m/s.
  const CanvasGeometry geometry{3, 3, 0.003, 0.006};
  TestCanvas canvas(geometry);
  canvas.gravity = {0, 0, 10};
  canvas.dt_s = 1;
  canvas.flood(0.01f, 0);
  const StepConstants k = make_step_constants(
      geometry,
      {canvas.model, canvas.gravity, canvas.dt_s, canvas.contact, canvas.amount, canvas.threads});
  Planes p = make_planes(3, 3, 1);
  p.mobility_frac.fill(1);
  Field<float> height_m(3, 3);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      height_m(x, y) = 0.01f + 1e-4f * static_cast<float>(x) + 4e-4f * static_cast<float>(y);
  accelerate_row(k, canvas.state, height_m, 1, {0, 3}, p);
  // Heights of 1 cm are rounded to 1e-9, which 1/dx and gravity make 5e-6.
  EXPECT_NEAR(p.u_m_s[0](1, 1), -1, 1e-5f);
  EXPECT_NEAR(p.v_m_s[0](1, 1), -2, 1e-5f);
}

}  // namespace
}  // namespace pentimento::paper

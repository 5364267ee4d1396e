#include "core/fluid/paper/viscosity.h"

#include <gtest/gtest.h>

#include "tests/core/fluid/paper/canvases.h"

namespace pentimento::paper {
namespace {

TEST(Viscosity, CountsEachAxisBySquaresOfItsOwnCells) {
  // Cells of 1 mm by 2 mm, dt = 1 s, nu = 1e-6 m^2/s: dt nu / dx^2 = 1 and dt nu / dy^2 = 1/4, so
  // the diagonal is 1 + 2 + 1/2.
  const CanvasGeometry geometry{3, 3, 0.003, 0.006};
  TestCanvas canvas(geometry);
  canvas.dt_s = 1;
  const StepConstants k = make_step_constants(
      geometry,
      {canvas.model, canvas.gravity, canvas.dt_s, canvas.contact, canvas.amount, canvas.threads});
  Planes p = make_planes(3, 3, 1);
  p.wet.fill(1);
  p.viscosity_m2_s.fill(1e-6f);
  build_viscosity_row(k, 1, {0, 3}, p);
  EXPECT_FLOAT_EQ(p.system.centre(1, 1), 1 / 3.5f);
  EXPECT_FLOAT_EQ(p.system.left(1, 1), 1 / 3.5f);
  EXPECT_FLOAT_EQ(p.system.right(1, 1), 1 / 3.5f);
  EXPECT_FLOAT_EQ(p.system.up(1, 1), 0.25f / 3.5f);
  EXPECT_FLOAT_EQ(p.system.down(1, 1), 0.25f / 3.5f);
}

}  // namespace
}  // namespace pentimento::paper

#include "core/fluid/paper/viscosity.h"

namespace pentimento::paper {

namespace {

void sweep_component_row(const Stencil& system, const Field<float>& right_side,
                         const Field<float>& component, int y, Columns cells, float* out) {
  const Rows u = rows_at(component, y);
  const float* u0 = right_side.row(y);
  const float *centre = system.centre.row(y), *left = system.left.row(y);
  const float *right = system.right.row(y), *up = system.up.row(y), *down = system.down.row(y);
  for_cells(cells, component.width(), [=](int x, int l, int r) {
    out[x] = centre[x] * u0[x] + ((left[x] * u.here[l] + right[x] * u.here[r]) +
                                  (up[x] * u.above[x] + down[x] * u.below[x]));
  });
}

}  // namespace

void build_viscosity_row(const StepConstants& k, int y, Columns cells, Planes& planes) {
  const Rows wet = rows_at(planes.wet, y);
  const float* nu = planes.viscosity_m2_s.row(y);
  Stencil& s = planes.system;
  float *centre = s.centre.row(y), *left = s.left.row(y), *right = s.right.row(y);
  float *up = s.up.row(y), *down = s.down.row(y);
  const float per_x = k.dt_s / (k.dx_m * k.dx_m), per_y = k.dt_s / (k.dy_m * k.dy_m);
  for_cells(cells, planes.wet.width(), [=](int x, int l, int r) {
    const float cx = nu[x] * per_x, cy = nu[x] * per_y;
    const float wl = cx * wet.here[l], wr = cx * wet.here[r];
    const float wu = cy * wet.above[x], wd = cy * wet.below[x];
    const float inverse = 1.0f / (1.0f + ((wl + wr) + (wu + wd)));
    centre[x] = inverse;
    left[x] = wl * inverse;
    right[x] = wr * inverse;
    up[x] = wu * inverse;
    down[x] = wd * inverse;
  });
}

void sweep_viscosity_row(const Stencil& system, const Velocity& right_side,
                         const Velocity& velocity, int y, Columns cells, float* out_u,
                         float* out_v) {
  sweep_component_row(system, right_side.u_m_s, velocity.u_m_s, y, cells, out_u);
  sweep_component_row(system, right_side.v_m_s, velocity.v_m_s, y, cells, out_v);
}

}  // namespace pentimento::paper

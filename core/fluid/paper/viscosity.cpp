#include "core/fluid/paper/viscosity.h"

namespace pentimento::paper {

void sweep_viscosity_row(const StepConstants& k, const Planes& planes, const Velocity& right_side,
                         const Velocity& velocity, int y, Columns cells, float* out_u,
                         float* out_v) {
  const Rows u = rows_at(velocity.u_m_s, y), v = rows_at(velocity.v_m_s, y);
  const Rows wet = rows_at(planes.wet, y);
  const float *u0 = right_side.u_m_s.row(y), *v0 = right_side.v_m_s.row(y);
  const float* nu = planes.viscosity_m2_s.row(y);
  const float per_x = k.dt_s / (k.dx_m * k.dx_m), per_y = k.dt_s / (k.dy_m * k.dy_m);
  for_cells(cells, planes.wet.width(), [=](int x, int l, int r) {
    const float cx = nu[x] * per_x, cy = nu[x] * per_y;
    const float wl = cx * wet.here[l], wr = cx * wet.here[r];
    const float wu = cy * wet.above[x], wd = cy * wet.below[x];
    const float inverse = 1.0f / (1.0f + ((wl + wr) + (wu + wd)));
    out_u[x] = (u0[x] + ((wl * u.here[l] + wr * u.here[r]) + (wu * u.above[x] + wd * u.below[x]))) *
               inverse;
    out_v[x] = (v0[x] + ((wl * v.here[l] + wr * v.here[r]) + (wu * v.above[x] + wd * v.below[x]))) *
               inverse;
  });
}

}  // namespace pentimento::paper

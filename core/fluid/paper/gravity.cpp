#include "core/fluid/paper/gravity.h"

namespace pentimento::paper {

void accelerate_row(const StepConstants& k, const CanvasState& state, const Field<float>& height_m,
                    int y, Columns cells, Planes& planes) {
  const Rows h = rows_at(height_m, y);
  const float* d = state.depth_m.row(y);
  const float* mobility = planes.mobility_frac.row(y);
  float *u = planes.u_m_s[0].row(y), *v = planes.v_m_s[0].row(y);
  const float slope_x = k.gravity_z_m_s2 * 0.5f / k.dx_m,
              slope_y = k.gravity_z_m_s2 * 0.5f / k.dy_m;
  const float gx = k.gravity_x_m_s2, gy = k.gravity_y_m_s2, dt = k.dt_s, dry = k.dry_film_m;
  const bool lateral_is_scaled = k.phi_scales_lateral;
  for_cells(cells, height_m.width(), [=](int x, int l, int r) {
    const bool is_thin = (d[x] < dry) & (mobility[x] == 0.0f);
    const float thick = is_thin ? 0.0f : 1.0f;
    const float lateral = lateral_is_scaled ? mobility[x] : thick;
    u[x] -= dt * (mobility[x] * (slope_x * (h.here[r] - h.here[l])) + lateral * gx);
    v[x] -= dt * (mobility[x] * (slope_y * (h.below[x] - h.above[x])) + lateral * gy);
  });
}

}  // namespace pentimento::paper

#include "core/fluid/paper/height_system.h"

namespace pentimento::paper {

namespace {

/// The largest weight of the relief that the diagonal still dominates: both axes together may
/// exceed the film's weights by the 1 of the diagonal.
constexpr float kReliefBeyondFilm = 0.25f;

float limited(float relief, float film) {
  const float most = film + kReliefBeyondFilm;
  const float not_above = relief < most ? relief : most;
  return not_above > -most ? not_above : -most;
}

}  // namespace

void build_height_system_row(const StepConstants& k, const CanvasState& state, int y, Columns cells,
                             Planes& planes) {
  const Rows b = rows_at(state.base_m, y), v = rows_at(planes.v_m_s[0], y);
  const float* u = planes.u_m_s[0].row(y);
  const float* d = state.depth_m.row(y);
  const float* mobility = planes.mobility_frac.row(y);
  Stencil& s = planes.system;
  float *centre = s.centre.row(y), *left = s.left.row(y), *right = s.right.row(y);
  float *up = s.up.row(y), *down = s.down.row(y);
  const float half_dx = 0.5f / k.dx_m, half_dy = 0.5f / k.dy_m;
  const float per_dx2 = 1.0f / (k.dx_m * k.dx_m), per_dy2 = 1.0f / (k.dy_m * k.dy_m);
  const float g_dt2 = k.gravity_z_m_s2 * k.dt_s * k.dt_s, dt = k.dt_s;
  for_cells(cells, state.geometry.width, [=](int x, int l, int r) {
    const float bx = (b.here[r] - b.here[l]) * half_dx, by = (b.below[x] - b.above[x]) * half_dy;
    const float divergence = (u[r] - u[l]) * half_dx + (v.below[x] - v.above[x]) * half_dy;
    const float advected = u[x] * bx + v.here[x] * by;
    const float g = g_dt2 * mobility[x];
    const float film_x = g * d[x] * per_dx2, film_y = g * d[x] * per_dy2;
    const float relief_x = limited(g * bx * half_dx, film_x);
    const float relief_y = limited(g * by * half_dy, film_y);
    const float inverse = 1.0f / (1.0f + 2.0f * (film_x + film_y));
    centre[x] = (centre[x] + dt * (advected - d[x] * divergence)) * inverse;
    left[x] = (film_x + relief_x) * inverse;
    right[x] = (film_x - relief_x) * inverse;
    up[x] = (film_y + relief_y) * inverse;
    down[x] = (film_y - relief_y) * inverse;
  });
}

}  // namespace pentimento::paper

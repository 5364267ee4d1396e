#include "core/fluid/paper/height_system.h"

#include "core/base/kernel.h"

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

/// The rows that the system of one row is built from, and those that it is.
struct SystemRows {
  Rows base_m, v_m_s;
  const float *u_m_s, *depth_m, *mobility_frac;
  float *centre, *left, *right, *up, *down;
};

/// What is the same in all cells.
struct SystemConstants {
  float half_dx, half_dy, per_dx2, per_dy2, g_dt2, dt_s;
};

/// Cell x, with its neighbours' columns.
inline void build_cell(const SystemConstants& k, const SystemRows& s, int x, int l, int r) {
  const float* u = s.u_m_s;
  const float bx = (s.base_m.here[r] - s.base_m.here[l]) * k.half_dx;
  const float by = (s.base_m.below[x] - s.base_m.above[x]) * k.half_dy;
  const float divergence =
      (u[r] - u[l]) * k.half_dx + (s.v_m_s.below[x] - s.v_m_s.above[x]) * k.half_dy;
  const float advected = u[x] * bx + s.v_m_s.here[x] * by;
  const float g = k.g_dt2 * s.mobility_frac[x], depth = s.depth_m[x];
  const float film_x = g * depth * k.per_dx2, film_y = g * depth * k.per_dy2;
  const float relief_x = limited(g * bx * k.half_dx, film_x);
  const float relief_y = limited(g * by * k.half_dy, film_y);
  const float inverse = 1.0f / (1.0f + 2.0f * (film_x + film_y));
  s.centre[x] = (s.centre[x] + k.dt_s * (advected - depth * divergence)) * inverse;
  s.left[x] = (film_x + relief_x) * inverse;
  s.right[x] = (film_x - relief_x) * inverse;
  s.up[x] = (film_y + relief_y) * inverse;
  s.down[x] = (film_y - relief_y) * inverse;
}

PENTIMENTO_KERNEL
void build_cells(const SystemConstants& constants, const SystemRows& rows, int begin, int end) {
  const SystemConstants k = constants;
  const SystemRows s = rows;
  PENTIMENTO_INDEPENDENT
  for (int x = begin; x < end; ++x) build_cell(k, s, x, x - 1, x + 1);
}

}  // namespace

void build_height_system_row(const StepConstants& k, const CanvasState& state, int y, Columns cells,
                             Planes& planes) {
  Stencil& s = planes.system;
  const SystemRows rows{rows_at(state.base_m, y),
                        rows_at(planes.v_m_s[0], y),
                        planes.u_m_s[0].row(y),
                        state.depth_m.row(y),
                        planes.mobility_frac.row(y),
                        s.centre.row(y),
                        s.left.row(y),
                        s.right.row(y),
                        s.up.row(y),
                        s.down.row(y)};
  const SystemConstants constants{.half_dx = 0.5f / k.dx_m,
                                  .half_dy = 0.5f / k.dy_m,
                                  .per_dx2 = 1.0f / (k.dx_m * k.dx_m),
                                  .per_dy2 = 1.0f / (k.dy_m * k.dy_m),
                                  .g_dt2 = k.gravity_z_m_s2 * k.dt_s * k.dt_s,
                                  .dt_s = k.dt_s};
  for_edges_and_inside(
      cells, state.geometry.width,
      [&](int x, int l, int r) { build_cell(constants, rows, x, l, r); },
      [&](int begin, int end) { build_cells(constants, rows, begin, end); });
}

}  // namespace pentimento::paper

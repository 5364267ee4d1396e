#include "core/fluid/paper/trace.h"

#include <utility>

#include "core/fluid/paper/departure.h"

namespace pentimento::paper {

namespace {

/// The cell whose centre is nearest to the departure point, as (x, y).
std::pair<int, int> nearest(const Departure& p) {
  return {p.fx < 0.5f ? p.x0 : p.x1, p.fy < 0.5f ? p.y0 : p.y1};
}

}  // namespace

void trace_row(const StepConstants& k, const CanvasState& state, int y, Columns cells,
               const TracedRow& out) {
  const GridShape grid = shape_of(state.depth_m);
  const float cells_per_u = k.dt_s / k.dx_m, cells_per_v = k.dt_s / k.dy_m;
  const float* u = state.velocity_x_m_s.row(y);
  const float* v = state.velocity_y_m_s.row(y);
  const float* d = state.depth_m.row(y);
  const float* b = state.base_m.row(y);
  for (int x = cells.begin; x < cells.end; ++x) {
    out.u_m_s[x] = 0.0f;
    out.v_m_s[x] = 0.0f;
    out.height_m[x] = d[x] + b[x];
    if (u[x] == 0.0f && v[x] == 0.0f) continue;
    const Departure from = depart(x, y, u[x] * cells_per_u, v[x] * cells_per_v, grid);
    const float traced_depth = interpolate(state.depth_m.row(0), from);
    if (d[x] == 0.0f && traced_depth == 0.0f) continue;
    out.u_m_s[x] = interpolate(state.velocity_x_m_s.row(0), from);
    out.v_m_s[x] = interpolate(state.velocity_y_m_s.row(0), from);
    out.height_m[x] = traced_depth + interpolate(state.base_m.row(0), from);
    if (d[x] >= k.dry_film_m) continue;
    // Reads thick cells only and writes thin ones, so rows do not disturb each other.
    const auto [from_x, from_y] = nearest(from);
    if (state.depth_m(from_x, from_y) >= k.dry_film_m)
      out.mobility_frac(x, y) = out.mobility_frac(from_x, from_y);
  }
}

}  // namespace pentimento::paper

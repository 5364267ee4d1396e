#include "core/fluid/paper/front.h"

#include <cmath>

namespace pentimento::paper {

namespace {

bool is_stamped(const BrushContact& contact, int x, int y) {
  return y >= contact.row_begin && y < contact.row_end && contact.weight(x, y) > 0.0f;
}

/// Cells that paint of this speed reaches in the step.
int reach_cells(float speed_m_s, float cells_per_speed) {
  return 1 + static_cast<int>(std::min(std::abs(speed_m_s) * cells_per_speed, 1e6f));
}

/// One run of cells from (x, y), exclusive, in steps of (dx, dy).
struct Run {
  int x, y, dx, dy, cells;
};

void receive(const Run& run, const CanvasState& state, float thin, const Velocity& velocity,
             Reach& reach) {
  const float u = velocity.u_m_s(run.x, run.y), v = velocity.v_m_s(run.x, run.y);
  int x = run.x, y = run.y;
  for (int i = 0; i < run.cells; ++i) {
    x += run.dx;
    y += run.dy;
    if (x < 0 || x >= state.geometry.width || y < 0 || y >= state.geometry.height) return;
    if (state.depth_m(x, y) >= thin) return;
    reach.u_m_s(x, y) += u;
    reach.v_m_s(x, y) += v;
    reach.count(x, y) += 1.0f;
  }
}

/// Whether any of the cells of row y is thin; false outside the canvas.
bool any_thin(const Field<float>& depth_m, float thin, int y, Columns cells) {
  if (y < 0 || y >= depth_m.height()) return false;
  const float* d = depth_m.row(y);
  int count = 0;
  for (int x = cells.begin; x < cells.end; ++x) count += d[x] < thin ? 1 : 0;
  return count != 0;
}

}  // namespace

void reach_along_row(const StepConstants& k, const CanvasState& state, const BrushContact& contact,
                     const Velocity& velocity, int y, Columns cells, Reach& reach) {
  const int width = state.geometry.width;
  const float* d = state.depth_m.row(y);
  const float* u = velocity.u_m_s.row(y);
  if (!any_thin(state.depth_m, k.dry_film_m, y, widened(cells, width))) return;
  for (int x = cells.begin; x < cells.end; ++x) {
    if (u[x] == 0.0f || d[x] < k.dry_film_m) continue;
    const int ahead = u[x] > 0.0f ? x + 1 : x - 1;
    if (ahead < 0 || ahead >= width || d[ahead] >= k.dry_film_m) continue;
    if (is_stamped(contact, x, y)) continue;
    receive({x, y, ahead - x, 0, reach_cells(u[x], k.dt_s / k.dx_m)}, state, k.dry_film_m, velocity,
            reach);
  }
}

void reach_along_columns(const StepConstants& k, const CanvasState& state,
                         const BrushContact& contact, const Velocity& velocity, Columns cells,
                         int row_begin, int row_end, Reach& reach) {
  const int height = state.geometry.height;
  for (int y = row_begin; y < row_end; ++y) {
    const float* d = state.depth_m.row(y);
    const float* v = velocity.v_m_s.row(y);
    if (!any_thin(state.depth_m, k.dry_film_m, y - 1, cells) &&
        !any_thin(state.depth_m, k.dry_film_m, y + 1, cells))
      continue;
    for (int x = cells.begin; x < cells.end; ++x) {
      if (v[x] == 0.0f || d[x] < k.dry_film_m) continue;
      const int ahead = v[x] > 0.0f ? y + 1 : y - 1;
      if (ahead < 0 || ahead >= height || state.depth_m(x, ahead) >= k.dry_film_m) continue;
      if (is_stamped(contact, x, y)) continue;
      receive({x, y, 0, ahead - y, reach_cells(v[x], k.dt_s / k.dy_m)}, state, k.dry_film_m,
              velocity, reach);
    }
  }
}

bool update_velocity_row(const BrushContact& contact, const Velocity& velocity, const Reach& reach,
                         int y, Columns cells, CanvasState& state) {
  const float* d = state.depth_m.row(y);
  const float *u = velocity.u_m_s.row(y), *v = velocity.v_m_s.row(y);
  const float *reach_u = reach.u_m_s.row(y), *reach_v = reach.v_m_s.row(y);
  const float* count = reach.count.row(y);
  const float* weight = contact.weight.row(y);
  float* out_u = state.velocity_x_m_s.row(y);
  float* out_v = state.velocity_y_m_s.row(y);
  int changed = 0;
  for (int x = cells.begin; x < cells.end; ++x) {
    const bool wet = d[x] > 0.0f, reached = (count[x] > 0.0f) & !(wet & (weight[x] > 0.0f));
    const float share = 1.0f / std::max(count[x], 1.0f);
    const float own_u = wet ? u[x] : 0.0f, own_v = wet ? v[x] : 0.0f;
    const float new_u = reached ? reach_u[x] * share : own_u;
    const float new_v = reached ? reach_v[x] * share : own_v;
    changed |= static_cast<int>(new_u != out_u[x]) | static_cast<int>(new_v != out_v[x]);
    out_u[x] = new_u;
    out_v[x] = new_v;
  }
  return changed != 0;
}

}  // namespace pentimento::paper

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

}  // namespace

void reach_along_row(const StepConstants& k, const CanvasState& state, const BrushContact& contact,
                     const Velocity& velocity, int y, Columns cells, Reach& reach) {
  const int width = state.geometry.width;
  const float* d = state.depth_m.row(y);
  const float* u = velocity.u_m_s.row(y);
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
  const int last_x = state.geometry.width - 1, last_y = state.geometry.height - 1;
  const float* d = state.depth_m.row(y);
  const float *u = velocity.u_m_s.row(y), *v = velocity.v_m_s.row(y);
  const float *reach_u = reach.u_m_s.row(y), *reach_v = reach.v_m_s.row(y);
  const float* count = reach.count.row(y);
  const bool stamped_row = y >= contact.row_begin && y < contact.row_end;
  const bool edge_row = y == 0 || y == last_y;
  float* out_u = state.velocity_x_m_s.row(y);
  float* out_v = state.velocity_y_m_s.row(y);
  bool changed = false;
  for (int x = cells.begin; x < cells.end; ++x) {
    const bool wet = d[x] > 0.0f;
    float new_u = wet ? u[x] : 0.0f, new_v = wet ? v[x] : 0.0f;
    const bool held = wet && stamped_row && contact.weight(x, y) > 0.0f;
    if (count[x] > 0.0f && !held) {
      new_u = reach_u[x] / count[x];
      new_v = reach_v[x] / count[x];
    }
    if (x == 0 || x == last_x) new_u = 0.0f;
    if (edge_row) new_v = 0.0f;
    changed |= new_u != out_u[x] || new_v != out_v[x];
    out_u[x] = new_u;
    out_v[x] = new_v;
  }
  return changed;
}

}  // namespace pentimento::paper

#include "core/fluid/paper/wet_front.h"

#include "core/base/any_not_zero.h"
#include "core/base/kernel.h"

namespace pentimento::paper {

namespace {

bool is_stamped(const BrushContact& contact, int x, int y) {
  return y >= contact.row_begin && y < contact.row_end && contact.weight(x, y) > 0.0f;
}

/// The foremost cell of a film, and the direction in which it flows: (1,0), (-1,0), (0,1), (0,-1).
struct FrontCell {
  int x, y, dx, dy;
};

/// Velocity along the direction of the front, in cells per step, for either axis.
struct FrontAxis {
  const CanvasState& state;
  const Field<float>& velocity_m_s;  // u along rows, v along columns
  float cells_per_speed;
  float thin_m;

  bool is_inside(int x, int y) const {
    return x >= 0 && x < state.geometry.width && y >= 0 && y < state.geometry.height;
  }
  bool is_thick(int x, int y) const { return is_inside(x, y) && state.depth_m(x, y) >= thin_m; }
  float travel(const FrontCell& f, int x, int y) const {
    return velocity_m_s(x, y) * cells_per_speed * static_cast<float>(f.dx + f.dy);
  }
};

/// How many cells the film advances: n if its foremost n cells all travel at least n - 1. A front
/// that runs away from its film (spreading) gets one cell, or it would be copied, not moved.
int advance_cells(const FrontAxis& along, const FrontCell& f) {
  float slowest = along.travel(f, f.x, f.y);
  int n = 1;
  while (slowest >= static_cast<float>(n)) {
    const int x = f.x - n * f.dx, y = f.y - n * f.dy;
    if (!along.is_thick(x, y)) break;
    slowest = std::min(slowest, along.travel(f, x, y));
    if (slowest < static_cast<float>(n)) break;
    ++n;
  }
  return n;
}

/// Gives the front's velocity to the thin cells into which the film advances.
void advance(const FrontAxis& along, const FrontCell& f, const Velocity& velocity,
             FrontInflow& inflow) {
  const float u = velocity.u_m_s(f.x, f.y), v = velocity.v_m_s(f.x, f.y);
  const int cells = advance_cells(along, f);
  for (int i = 1; i <= cells; ++i) {
    const int x = f.x + i * f.dx, y = f.y + i * f.dy;
    if (!along.is_inside(x, y) || along.is_thick(x, y)) return;
    inflow.u_m_s(x, y) += u;
    inflow.v_m_s(x, y) += v;
    inflow.count(x, y) += 1.0f;
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

void advance_front_along_row(const StepConstants& k, const CanvasState& state,
                             const BrushContact& contact, const Velocity& velocity, int y,
                             Columns cells, FrontInflow& inflow) {
  const int width = state.geometry.width;
  const FrontAxis along{state, velocity.u_m_s, k.dt_s / k.dx_m, k.dry_film_m};
  const float* d = state.depth_m.row(y);
  const float* u = velocity.u_m_s.row(y);
  if (!any_thin(state.depth_m, k.dry_film_m, y, widened(cells, width))) return;
  for (int x = cells.begin; x < cells.end; ++x) {
    if (u[x] == 0.0f || d[x] < k.dry_film_m) continue;
    const int ahead = u[x] > 0.0f ? x + 1 : x - 1;
    if (ahead < 0 || ahead >= width || d[ahead] >= k.dry_film_m) continue;
    if (is_stamped(contact, x, y)) continue;
    advance(along, {x, y, ahead - x, 0}, velocity, inflow);
  }
}

void advance_front_along_columns(const StepConstants& k, const CanvasState& state,
                                 const BrushContact& contact, const Velocity& velocity,
                                 Columns cells, int row_begin, int row_end, FrontInflow& inflow) {
  const int height = state.geometry.height;
  const FrontAxis along{state, velocity.v_m_s, k.dt_s / k.dy_m, k.dry_film_m};
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
      advance(along, {x, y, 0, ahead - y}, velocity, inflow);
    }
  }
}

bool any_inflow(const FrontInflow& inflow, int y, Columns cells) {
  return any_not_zero(inflow.count.row(y) + cells.begin, static_cast<int>(cells.count()));
}

void clear_inflow(int y, Columns cells, FrontInflow& inflow) {
  for (Field<float>* f : {&inflow.u_m_s, &inflow.v_m_s, &inflow.count})
    std::fill_n(f->row(y) + cells.begin, cells.count(), 0.0f);
}

PENTIMENTO_KERNEL
bool update_velocity_row(const Velocity& velocity, int y, Columns cells, CanvasState& state) {
  const float* d = state.depth_m.row(y);
  const float *u = velocity.u_m_s.row(y), *v = velocity.v_m_s.row(y);
  float* out_u = state.velocity_x_m_s.row(y);
  float* out_v = state.velocity_y_m_s.row(y);
  int changed = 0;
  for (int x = cells.begin; x < cells.end; ++x) {
    const float new_u = d[x] > 0.0f ? u[x] : 0.0f, new_v = d[x] > 0.0f ? v[x] : 0.0f;
    changed |= static_cast<int>(new_u != out_u[x]) | static_cast<int>(new_v != out_v[x]);
    out_u[x] = new_u;
    out_v[x] = new_v;
  }
  return changed != 0;
}

PENTIMENTO_KERNEL
bool update_velocity_row(const BrushContact& contact, const Velocity& velocity,
                         const FrontInflow& inflow, int y, Columns cells, CanvasState& state) {
  const float* d = state.depth_m.row(y);
  const float *u = velocity.u_m_s.row(y), *v = velocity.v_m_s.row(y);
  const float *inflow_u = inflow.u_m_s.row(y), *inflow_v = inflow.v_m_s.row(y);
  const float* count = inflow.count.row(y);
  const float* weight = contact.weight.row(y);
  float* out_u = state.velocity_x_m_s.row(y);
  float* out_v = state.velocity_y_m_s.row(y);
  int changed = 0;
  for (int x = cells.begin; x < cells.end; ++x) {
    const float film = d[x], stamped = weight[x], films = count[x];
    const float own_u = u[x], own_v = v[x], sum_u = inflow_u[x], sum_v = inflow_v[x];
    const bool reached = (films > 0.0f) & ((film == 0.0f) | (stamped == 0.0f));
    const float share = 1.0f / (films > 1.0f ? films : 1.0f);
    const float new_u = reached ? sum_u * share : (film > 0.0f ? own_u : 0.0f);
    const float new_v = reached ? sum_v * share : (film > 0.0f ? own_v : 0.0f);
    changed |= static_cast<int>(new_u != out_u[x]) | static_cast<int>(new_v != out_v[x]);
    out_u[x] = new_u;
    out_v[x] = new_v;
  }
  return changed != 0;
}

}  // namespace pentimento::paper

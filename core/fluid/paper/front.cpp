#include "core/fluid/paper/front.h"

#include "core/fluid/paper/velocity_limits.h"

namespace pentimento::paper {

namespace {

/// Sum of the velocities that flow into a cell, and their number.
struct Inflow {
  float u = 0, v = 0, count = 0;
  void add(bool flows_in, float neighbour_u, float neighbour_v) {
    u += flows_in ? neighbour_u : 0.0f;
    v += flows_in ? neighbour_v : 0.0f;
    count += flows_in ? 1.0f : 0.0f;
  }
};

}  // namespace

bool update_velocity_row(const StepConstants& k, const BrushContact& contact,
                         const Field<float>& u_m_s, const Field<float>& v_m_s, int y, Columns cells,
                         CanvasState& state) {
  const int width = state.geometry.width, height = state.geometry.height;
  const Rows d = rows_at(state.depth_m, y), u = rows_at(u_m_s, y), v = rows_at(v_m_s, y);
  const bool stamped = y >= contact.row_begin && y < contact.row_end;
  const float* weight = stamped ? contact.weight.row(y) : nullptr;
  float* out_u = state.velocity_x_m_s.row(y);
  float* out_v = state.velocity_y_m_s.row(y);
  const float thin = k.dry_film_m;
  int changed = 0;
  for_cells(cells, width, [=, &changed](int x, int l, int r) {
    Inflow in;
    in.add((d.here[l] >= thin) & (u.here[l] > 0.0f), u.here[l], v.here[l]);
    in.add((d.here[r] >= thin) & (u.here[r] < 0.0f), u.here[r], v.here[r]);
    in.add((d.above[x] >= thin) & (v.above[x] > 0.0f), u.above[x], v.above[x]);
    in.add((d.below[x] >= thin) & (v.below[x] < 0.0f), u.below[x], v.below[x]);
    const bool wet = d.here[x] > 0.0f, held = stamped && weight[x] > 0.0f && wet;
    const bool carried = (d.here[x] < thin) & (in.count > 0.0f) & !held;
    const float share = 1.0f / std::max(in.count, 1.0f);
    float new_u = carried ? in.u * share : (wet ? u.here[x] : 0.0f);
    float new_v = carried ? in.v * share : (wet ? v.here[x] : 0.0f);
    if (x == 0 || x == width - 1) new_u = 0.0f;
    if (y == 0 || y == height - 1) new_v = 0.0f;
    changed |= (new_u != out_u[x]) | (new_v != out_v[x]) ? 1 : 0;
    out_u[x] = new_u;
    out_v[x] = new_v;
  });
  return changed != 0;
}

}  // namespace pentimento::paper

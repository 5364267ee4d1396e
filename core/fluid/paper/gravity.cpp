#include "core/fluid/paper/gravity.h"

#include "core/base/kernel.h"

namespace pentimento::paper {

namespace {

/// What a row is accelerated by.
struct GravityRows {
  Rows height_m;
  const float *depth_m, *mobility_frac;
  float *u_m_s, *v_m_s;
};

/// What is the same in all cells.
struct GravityConstants {
  float slope_x, slope_y, gx, gy, dt_s, dry_film_m;
  bool lateral_is_scaled;
};

inline void accelerate_cell(const GravityConstants& k, const GravityRows& row, int x, int l,
                            int r) {
  const float mobility = row.mobility_frac[x];
  const bool is_thin = (row.depth_m[x] < k.dry_film_m) & (mobility == 0.0f);
  const float thick = is_thin ? 0.0f : 1.0f;
  const float lateral = k.lateral_is_scaled ? mobility : thick;
  const Rows& h = row.height_m;
  row.u_m_s[x] -= k.dt_s * (mobility * (k.slope_x * (h.here[r] - h.here[l])) + lateral * k.gx);
  row.v_m_s[x] -= k.dt_s * (mobility * (k.slope_y * (h.below[x] - h.above[x])) + lateral * k.gy);
}

PENTIMENTO_KERNEL
void accelerate_cells(const GravityConstants& constants, const GravityRows& rows, int begin,
                      int end) {
  const GravityConstants k = constants;
  const GravityRows row = rows;
  PENTIMENTO_INDEPENDENT
  for (int x = begin; x < end; ++x) accelerate_cell(k, row, x, x - 1, x + 1);
}

}  // namespace

void accelerate_row(const StepConstants& k, const CanvasState& state, const Field<float>& height_m,
                    int y, Columns cells, Planes& planes) {
  const GravityRows row{rows_at(height_m, y), state.depth_m.row(y), planes.mobility_frac.row(y),
                        planes.u_m_s[0].row(y), planes.v_m_s[0].row(y)};
  const GravityConstants constants{.slope_x = k.gravity_z_m_s2 * 0.5f / k.dx_m,
                                   .slope_y = k.gravity_z_m_s2 * 0.5f / k.dy_m,
                                   .gx = k.gravity_x_m_s2,
                                   .gy = k.gravity_y_m_s2,
                                   .dt_s = k.dt_s,
                                   .dry_film_m = k.dry_film_m,
                                   .lateral_is_scaled = k.phi_scales_lateral};
  for_edges_and_inside(
      cells, height_m.width(),
      [&](int x, int l, int r) { accelerate_cell(constants, row, x, l, r); },
      [&](int begin, int end) { accelerate_cells(constants, row, begin, end); });
}

}  // namespace pentimento::paper

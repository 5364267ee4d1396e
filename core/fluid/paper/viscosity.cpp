#include "core/fluid/paper/viscosity.h"

#include "core/base/kernel.h"

namespace pentimento::paper {

namespace {

/// What the weights of a row follow from.
struct ViscousRow {
  Rows wet;
  const float* viscosity_m2_s;
  float per_x, per_y;  // dt / dx^2, dt / dy^2
};

/// The weights of a row, to write.
struct WeightRows {
  float *centre, *left, *right, *up, *down;
};

/// Cell x, with its neighbours' columns.
inline void build_viscous_cell(const ViscousRow& row, const WeightRows& w, int x, int l, int r) {
  const float cx = row.viscosity_m2_s[x] * row.per_x, cy = row.viscosity_m2_s[x] * row.per_y;
  const float wl = cx * row.wet.here[l], wr = cx * row.wet.here[r];
  const float wu = cy * row.wet.above[x], wd = cy * row.wet.below[x];
  const float inverse = 1.0f / (1.0f + ((wl + wr) + (wu + wd)));
  w.centre[x] = inverse;
  w.left[x] = wl * inverse;
  w.right[x] = wr * inverse;
  w.up[x] = wu * inverse;
  w.down[x] = wd * inverse;
}

PENTIMENTO_KERNEL
void build_viscous_cells(const ViscousRow& given, const WeightRows& given_weights, int begin,
                         int end) {
  const ViscousRow row = given;
  const WeightRows w = given_weights;
  PENTIMENTO_INDEPENDENT
  for (int x = begin; x < end; ++x) build_viscous_cell(row, w, x, x - 1, x + 1);
}

/// The weights of a row, to read.
struct SweptSystem {
  const float *centre, *left, *right, *up, *down;
};

/// One component of the velocity in three rows, its right side and where it goes.
struct ComponentRows {
  Rows from;
  const float* right_side;
  float* out;
};

/// A sweep of cell x, with its neighbours' columns.
inline void sweep_cell(const SweptSystem& s, const ComponentRows& c, int x, int l, int r) {
  c.out[x] =
      s.centre[x] * c.right_side[x] + ((s.left[x] * c.from.here[l] + s.right[x] * c.from.here[r]) +
                                       (s.up[x] * c.from.above[x] + s.down[x] * c.from.below[x]));
}

/// Both components at once, which have the same weights.
PENTIMENTO_KERNEL
void sweep_cells(const SweptSystem& given, const ComponentRows& given_u,
                 const ComponentRows& given_v, int begin, int end) {
  const SweptSystem s = given;
  const ComponentRows u = given_u, v = given_v;
  PENTIMENTO_INDEPENDENT
  for (int x = begin; x < end; ++x) {
    sweep_cell(s, u, x, x - 1, x + 1);
    sweep_cell(s, v, x, x - 1, x + 1);
  }
}

}  // namespace

void build_viscosity_row(const StepConstants& k, int y, Columns cells, Planes& planes) {
  Stencil& s = planes.system;
  const ViscousRow row{.wet = rows_at(planes.wet, y),
                       .viscosity_m2_s = planes.viscosity_m2_s.row(y),
                       .per_x = k.dt_s / (k.dx_m * k.dx_m),
                       .per_y = k.dt_s / (k.dy_m * k.dy_m)};
  const WeightRows weights{s.centre.row(y), s.left.row(y), s.right.row(y), s.up.row(y),
                           s.down.row(y)};
  for_edges_and_inside(
      cells, planes.wet.width(),
      [&](int x, int l, int r) { build_viscous_cell(row, weights, x, l, r); },
      [&](int begin, int end) { build_viscous_cells(row, weights, begin, end); });
}

void sweep_viscosity_row(const Stencil& system, const Velocity& right_side,
                         const Velocity& velocity, int y, Columns cells, float* out_u,
                         float* out_v) {
  const SweptSystem rows{system.centre.row(y), system.left.row(y), system.right.row(y),
                         system.up.row(y), system.down.row(y)};
  const ComponentRows u{rows_at(velocity.u_m_s, y), right_side.u_m_s.row(y), out_u};
  const ComponentRows v{rows_at(velocity.v_m_s, y), right_side.v_m_s.row(y), out_v};
  for_edges_and_inside(
      cells, velocity.u_m_s.width(),
      [&](int x, int l, int r) {
        sweep_cell(rows, u, x, l, r);
        sweep_cell(rows, v, x, l, r);
      },
      [&](int begin, int end) { sweep_cells(rows, u, v, begin, end); });
}

}  // namespace pentimento::paper

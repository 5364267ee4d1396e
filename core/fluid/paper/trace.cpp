#include "core/fluid/paper/trace.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/kernel.h"
#include "core/fluid/paper/departure.h"
#include "core/fluid/paper/near_departures.h"
#include "core/fluid/paper/near_values.h"

namespace pentimento::paper {

namespace {

/// The cell whose centre is nearest to the departure point, as (x, y).
std::pair<int, int> nearest(const Departure& p) {
  return {p.fx < 0.5f ? p.x0 : p.x1, p.fy < 0.5f ? p.y0 : p.y1};
}

/// What the planes hold at the departure points.
struct TracedValues {
  NearValues u_m_s, v_m_s, depth_m, base_m;
};

/// trace_cells() of the groups that have a side, but for the mobility, given the traced values and
/// the row's own depth and base. Says for each cell whether a film came into a thinner one than
/// `dry_film_m`, and returns whether any did.
PENTIMENTO_KERNEL
bool trace_groups(const NearDepartures& departures, const TracedValues& values,
                  const float* depth_row, const float* base_row, float dry_film_m,
                  const TracedRow& out, std::int32_t* entered_cells) {
  const int groups = departures.groups;
  std::int32_t any = 0;
  for (int g = 0; g < groups; ++g) {
    const NearGroup& group = departures.group[static_cast<std::size_t>(g)];
    if (group.side == 0) continue;
    const auto first = static_cast<std::size_t>(g) * kGroupCells;
    const std::int32_t* choice = departures.choice.data() + first;
    const float *traced_u = values.u_m_s.data() + first, *traced_v = values.v_m_s.data() + first;
    const float* traced_depth = values.depth_m.data() + first;
    const float* traced_base = values.base_m.data() + first;
    const float *depth = depth_row + group.x, *base = base_row + group.x;
    float* __restrict u_m_s = out.u_m_s + group.x;
    float* __restrict v_m_s = out.v_m_s + group.x;
    float* __restrict height_m = out.height_m + group.x;
    std::int32_t* __restrict entered = entered_cells + first;
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < kGroupCells; ++i) {
      const std::int32_t wet = (depth[i] != 0 ? 1 : 0) | (traced_depth[i] != 0 ? 1 : 0);
      const std::int32_t goes = ((choice[i] & kMovesBit) != 0 ? 1 : 0) & wet;
      const float height = traced_depth[i] + traced_base[i], own_height = depth[i] + base[i];
      u_m_s[i] = goes != 0 ? traced_u[i] : 0.0f;
      v_m_s[i] = goes != 0 ? traced_v[i] : 0.0f;
      height_m[i] = goes != 0 ? height : own_height;
      entered[i] = goes & (depth[i] < dry_film_m ? 1 : 0);
      any |= entered[i];
    }
  }
  return any != 0;
}

/// Takes the mobility of the film that came into the thin cell (x, y).
void take_mobility(const StepConstants& k, const CanvasState& state, int x, int y, int from_x,
                   int from_y, Field<float>& mobility_frac) {
  // Reads thick cells only and writes thin ones, so rows do not disturb each other.
  if (state.depth_m(from_x, from_y) >= k.dry_film_m)
    mobility_frac(x, y) = mobility_frac(from_x, from_y);
}

/// take_mobility() where a film came into a thinner cell of the groups.
void take_mobility_near(const StepConstants& k, const CanvasState& state, int y,
                        const NearDepartures& from, const std::int32_t* entered,
                        Field<float>& mobility_frac) {
  const int last_y = state.geometry.height - 1;
  for (int g = 0; g < from.groups; ++g) {
    const NearGroup& group = from.group[static_cast<std::size_t>(g)];
    for (int i = 0; group.side != 0 && i < kGroupCells; ++i) {
      const auto at = static_cast<std::size_t>(g * kGroupCells + i);
      if (entered[at] == 0) continue;
      const std::int32_t choice = from.choice[at];
      const int x = group.x + i;
      const int x0 = x + group.shift_x + chosen_of_three(choice, kFirstColumnBit, kThirdColumnBit);
      const int y0 = y + group.shift_y + chosen_of_three(choice, kFirstRowBit, kThirdRowBit);
      take_mobility(k, state, x, y, from.fx[at] < 0.5f ? x0 : x0 + 1,
                    from.fy[at] < 0.5f ? y0 : std::min(y0 + 1, last_y), mobility_frac);
    }
  }
}

}  // namespace

void trace_row(const StepConstants& k, const CanvasState& state, int y, Columns cells,
               const TracedRow& out) {
  const NearRow row{.y = y,
                    .grid = shape_of(state.depth_m),
                    .u_m_s = state.velocity_x_m_s.row(y),
                    .v_m_s = state.velocity_y_m_s.row(y)};
  TracedValues values;
  std::array<std::int32_t, kMostCells> entered;
  const auto near = [&](const NearDepartures& from) {
    interpolate_near(from, state.velocity_x_m_s, values.u_m_s);
    interpolate_near(from, state.velocity_y_m_s, values.v_m_s);
    interpolate_near(from, state.depth_m, values.depth_m);
    interpolate_near(from, state.base_m, values.base_m);
    if (trace_groups(from, values, state.depth_m.row(y), state.base_m.row(y), k.dry_film_m, out,
                     entered.data()))
      take_mobility_near(k, state, y, from, entered.data(), out.mobility_frac);
  };
  for_near_cells(k, row, cells, near, [&](int begin, int end) {
    trace_cells(k, state, y, {begin, end}, out);
  });
}

void trace_cells(const StepConstants& k, const CanvasState& state, int y, Columns cells,
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
    const auto [from_x, from_y] = nearest(from);
    take_mobility(k, state, x, y, from_x, from_y, out.mobility_frac);
  }
}

}  // namespace pentimento::paper

#include "core/fluid/paper/trace.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/kernel.h"
#include "core/fluid/paper/departure.h"
#include "core/fluid/paper/near_departures.h"

namespace pentimento::paper {

namespace {

/// The cell whose centre is nearest to the departure point, as (x, y).
std::pair<int, int> nearest(const Departure& p) {
  return {p.fx < 0.5f ? p.x0 : p.x1, p.fy < 0.5f ? p.y0 : p.y1};
}

/// Cells traced at a time. At the surface departure points part sooner than in the layers below,
/// and cells whose points part are traced one by one (docs/bench/paper_scheme.md has the times).
constexpr int kTracedTogether = 32;
static_assert(kTracedTogether <= kTogether);

/// The planes that are traced, around some cells of a row.
struct NearFluid {
  NearRows u_m_s, v_m_s, depth_m, base_m;
};

/// trace_cells() but for the mobility. Says for each cell whether a film came into a thinner one
/// than `dry_film_m`, and returns whether any did.
PENTIMENTO_KERNEL
bool trace_near(const NearDepartures& departures, const NearFluid& given, float dry_film_m, int n,
                float* __restrict u_m_s, float* __restrict v_m_s, float* __restrict height_m,
                std::int32_t* __restrict entered) {
  const NearFluid fluid = given;
  std::int32_t any = 0;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const auto at = [&](const NearRows& plane) {
      return interpolate_near(
          departures, i, [&](int row, int column) { return value_near(plane, i, row, column); });
    };
    const float traced_depth = at(fluid.depth_m), own_depth = fluid.depth_m.here[i];
    const std::int32_t wet = (own_depth != 0 ? 1 : 0) | (traced_depth != 0 ? 1 : 0);
    const std::int32_t goes = departures.moves[static_cast<std::size_t>(i)] & wet;
    const float u = at(fluid.u_m_s), v = at(fluid.v_m_s);
    const float height = traced_depth + at(fluid.base_m);
    const float own_height = own_depth + fluid.base_m.here[i];
    u_m_s[i] = goes != 0 ? u : 0.0f;
    v_m_s[i] = goes != 0 ? v : 0.0f;
    height_m[i] = goes != 0 ? height : own_height;
    entered[i] = goes & (own_depth < dry_film_m ? 1 : 0);
    any |= entered[i];
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

/// take_mobility() where a film came into a thinner cell.
void take_mobility_near(const StepConstants& k, const CanvasState& state, const NearCells& cells,
                        const NearDepartures& from, const std::int32_t* entered,
                        Field<float>& mobility_frac) {
  for (int i = 0; i < cells.n; ++i) {
    if (entered[i] == 0) continue;
    const auto at = static_cast<std::size_t>(i);
    const int x0 = cells.x + i + from.column[at], y0 = cells.y + from.row[at];
    take_mobility(k, state, cells.x + i, cells.y, from.fx[at] < 0.5f ? x0 : x0 + 1,
                  from.fy[at] < 0.5f ? y0 : std::min(y0 + 1, cells.last_y), mobility_frac);
  }
}

constexpr std::array<float, kTogether> whole_shares() {
  std::array<float, kTogether> share{};
  share.fill(1);
  return share;
}

}  // namespace

void trace_row(const StepConstants& k, const CanvasState& state, int y, Columns cells,
               const TracedRow& out) {
  static constexpr std::array<float, kTogether> kWhole = whole_shares();
  const GridShape grid = shape_of(state.depth_m);
  NearDepartures from;
  std::array<std::int32_t, kTogether> entered;
  const auto near = [&](int x, int n) {
    const float *u = state.velocity_x_m_s.row(y) + x, *v = state.velocity_y_m_s.row(y) + x;
    const NearCells some{x, y, n, grid.width - 1, grid.height - 1, u, v, kWhole.data()};
    if (!find_near(k, some, from)) return false;
    const auto rows = [&](const Field<float>& plane) { return rows_near(plane, x, y, from); };
    const NearFluid fluid{rows(state.velocity_x_m_s), rows(state.velocity_y_m_s),
                          rows(state.depth_m), rows(state.base_m)};
    if (trace_near(from, fluid, k.dry_film_m, n, out.u_m_s + x, out.v_m_s + x, out.height_m + x,
                   entered.data()))
      take_mobility_near(k, state, some, from, entered.data(), out.mobility_frac);
    return true;
  };
  for_near_cells(cells, grid.width, kTracedTogether, near, [&](int begin, int end) {
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

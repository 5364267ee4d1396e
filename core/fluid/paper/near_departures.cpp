#include "core/fluid/paper/near_departures.h"

#include <algorithm>

#include "core/base/kernel.h"

namespace pentimento::paper {

namespace {
PENTIMENTO_KERNEL
void find_departures(const StepConstants& k, const NearCells& given, NearDepartures& out) {
  const NearCells cells = given;
  const float cells_per_u = k.dt_s / k.dx_m, cells_per_v = k.dt_s / k.dy_m;
  const float own_y = static_cast<float>(cells.y);
  const float last_x = static_cast<float>(cells.last_x), last_y = static_cast<float>(cells.last_y);
  std::int32_t* __restrict column = out.column.data();
  std::int32_t* __restrict row = out.row.data();
  std::int32_t* __restrict moves = out.moves.data();
  float* __restrict fx = out.fx.data();
  float* __restrict fy = out.fy.data();
  // depart()
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < cells.n; ++i) {
    const float u = cells.u_m_s[i], v = cells.v_m_s[i];
    const float share = cells.share[i];
    const float own_x = static_cast<float>(cells.x + i);
    const float px = std::min(std::max(own_x - share * u * cells_per_u, 0.0f), last_x);
    const float py = std::min(std::max(own_y - share * v * cells_per_v, 0.0f), last_y);
    const int x0 = static_cast<int>(px), y0 = static_cast<int>(py);
    fx[i] = px - static_cast<float>(x0);
    fy[i] = py - static_cast<float>(y0);
    column[i] = x0 - (cells.x + i);
    row[i] = y0 - cells.y;
    moves[i] = (u != 0 ? 1 : 0) | (v != 0 ? 1 : 0);
  }
}

struct Extremes {
  std::int32_t least, most;
};

/// The least and the most of the values of cells that move; none: least > most.
PENTIMENTO_KERNEL
Extremes extremes_of(const std::int32_t* value, const std::int32_t* moves, int n) {
  constexpr std::int32_t kFar = 1 << 24;
  std::int32_t least = kFar, most = -kFar;
  for (int i = 0; i < n; ++i) {
    const std::int32_t low = moves[i] != 0 ? value[i] : kFar;
    const std::int32_t high = moves[i] != 0 ? value[i] : -kFar;
    least = low < least ? low : least;
    most = high > most ? high : most;
  }
  return {least, most};
}
}  // namespace

bool find_near(const StepConstants& k, const NearCells& cells, NearDepartures& out) {
  find_departures(k, cells, out);
  const Extremes columns = extremes_of(out.column.data(), out.moves.data(), cells.n);
  const Extremes rows = extremes_of(out.row.data(), out.moves.data(), cells.n);
  const bool any = columns.least <= columns.most;
  // Where nothing moves, any three columns do that the canvas has.
  out.shift_x = any ? columns.least : -1;
  out.shift_y = any ? rows.least : 0;
  return columns.most - out.shift_x <= 1 && rows.most - out.shift_y <= 1 &&
         cells.x + out.shift_x >= 0 && cells.x + cells.n - 1 + out.shift_x + 2 <= cells.last_x;
}

}  // namespace pentimento::paper

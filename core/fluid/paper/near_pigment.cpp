#include "core/fluid/paper/near_pigment.h"

#include <algorithm>

#include "core/base/kernel.h"
#include "core/fluid/paper/departure.h"

namespace pentimento::paper {

namespace {
/// Which of three columns and rows a departure point lies between, and how far.
struct AmongThree {
  bool first_columns, first_rows;
  float fx, fy;
};
inline AmongThree among_three(const NearDepartures& d, int i) {
  const auto at = static_cast<std::size_t>(i);
  return {d.column[at] == d.shift_x, d.row[at] == d.shift_y, d.fx[at], d.fy[at]};
}

/// interpolate() among nine cells: value(row, column) with 0, 1 and 2.
template <typename Value>
inline float interpolate_near(const AmongThree& b, const Value& value) {
  const float top_0 = b.first_rows ? value(0, 0) : value(1, 0);
  const float top_1 = b.first_rows ? value(0, 1) : value(1, 1);
  const float top_2 = b.first_rows ? value(0, 2) : value(1, 2);
  const float bottom_0 = b.first_rows ? value(1, 0) : value(2, 0);
  const float bottom_1 = b.first_rows ? value(1, 1) : value(2, 1);
  const float bottom_2 = b.first_rows ? value(1, 2) : value(2, 2);
  const float top = mix(b.first_columns ? top_0 : top_1, b.first_columns ? top_1 : top_2, b.fx);
  const float bottom =
      mix(b.first_columns ? bottom_0 : bottom_1, b.first_columns ? bottom_1 : bottom_2, b.fx);
  return mix(top, bottom, b.fy);
}

PENTIMENTO_KERNEL
void find_departures(const StepConstants& k, int layer, const NearCells& given,
                     NearDepartures& out) {
  const NearCells cells = given;
  const float cells_per_u = k.dt_s / k.dx_m, cells_per_v = k.dt_s / k.dy_m;
  const float in_film = static_cast<float>(layer) + 0.5f;
  const float own_y = static_cast<float>(cells.y);
  const float last_x = static_cast<float>(cells.last_x), last_y = static_cast<float>(cells.last_y);
  std::int32_t* __restrict column = out.column.data();
  std::int32_t* __restrict row = out.row.data();
  std::int32_t* __restrict moves = out.moves.data();
  float* __restrict fx = out.fx.data();
  float* __restrict fy = out.fy.data();
  // layer_velocity_frac()
  std::array<std::int32_t, kTogether> occupied;
  for (int i = 0; i < cells.n; ++i) occupied[static_cast<std::size_t>(i)] = cells.occupied[i];
  // depart()
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < cells.n; ++i) {
    const float u = cells.u_m_s[i], v = cells.v_m_s[i];
    const std::int32_t layers = occupied[static_cast<std::size_t>(i)];
    const float share = in_film / static_cast<float>(layers > layer ? layers : layer + 1);
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

bool find_near(const StepConstants& k, int layer, const NearCells& cells, NearDepartures& out) {
  find_departures(k, layer, cells, out);
  const Extremes columns = extremes_of(out.column.data(), out.moves.data(), cells.n);
  const Extremes rows = extremes_of(out.row.data(), out.moves.data(), cells.n);
  const bool any = columns.least <= columns.most;
  // Where nothing moves, any three columns do that the canvas has.
  out.shift_x = any ? columns.least : -1;
  out.shift_y = any ? rows.least : 0;
  return columns.most - out.shift_x <= 1 && rows.most - out.shift_y <= 1 &&
         cells.x + out.shift_x >= 0 && cells.x + cells.n - 1 + out.shift_x + 2 <= cells.last_x;
}

PENTIMENTO_KERNEL
void arrive_near(const NearDepartures& departures, const NearRows& given, int n,
                 float* __restrict arrived) {
  const NearRows plane = given;
  for (int i = 0; i < n; ++i) {
    const float value = interpolate_near(among_three(departures, i), [&](int row, int column) {
      const float* from = row == 0   ? plane.from.above
                          : row == 1 ? plane.from.here
                                     : plane.from.below;
      return from[i + column];
    });
    const bool moves = departures.moves[static_cast<std::size_t>(i)] != 0;
    arrived[i] = moves ? without_tail(value) : plane.here[i];
  }
}

PENTIMENTO_KERNEL
void arrive_near_free(const NearDepartures& departures, const NearRows& given,
                      const NearRows& given_free, int n, float* __restrict arrived) {
  const NearRows plane = given, free = given_free;
  for (int i = 0; i < n; ++i) {
    const float value = interpolate_near(among_three(departures, i), [&](int row, int column) {
      const float* from = row == 0   ? plane.from.above
                          : row == 1 ? plane.from.here
                                     : plane.from.below;
      const float* share = row == 0 ? free.from.above : row == 1 ? free.from.here : free.from.below;
      return from[i + column] * share[i + column];
    });
    const float stays = (1.0f - free.here[i]) * plane.here[i];
    const bool moves = departures.moves[static_cast<std::size_t>(i)] != 0;
    arrived[i] = moves ? without_tail(value + stays) : plane.here[i];
  }
}

}  // namespace pentimento::paper

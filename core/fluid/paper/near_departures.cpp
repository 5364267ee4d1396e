#include "core/fluid/paper/near_departures.h"

#include <algorithm>
#include <bit>

#include "core/base/fetch_ahead.h"
#include "core/base/kernel.h"
#include "core/fluid/paper/pigment.h"

namespace pentimento::paper {

namespace {

/// Of the groups' cells: the share of the surface's velocity, and the column and row before each
/// departure point, seen from the cell.
struct FoundPoints {
  std::array<float, kMostCells> share;
  std::array<std::int32_t, kMostCells> column, row;
};

/// layer_velocity_frac() of a group's cells; 1 of the surface.
PENTIMENTO_KERNEL
void find_shares(int layer, const std::uint8_t* __restrict occupied, float* __restrict share) {
  for (int i = 0; i < kGroupCells; ++i) share[i] = layer_velocity_frac(layer, occupied[i]);
}

/// depart() of the groups' cells, given the shares.
PENTIMENTO_KERNEL
void find_points(const StepConstants& k, const NearRow& given, NearDepartures& out,
                 FoundPoints& points) {
  const float cells_per_u = k.dt_s / k.dx_m, cells_per_v = k.dt_s / k.dy_m;
  const float own_y = static_cast<float>(given.y);
  const int y = given.y;
  const float last_x = static_cast<float>(given.grid.width - 1);
  const float last_y = static_cast<float>(given.grid.height - 1);
  const int groups = out.groups;
  for (int g = 0; g < groups; ++g) {
    const int x = out.group[static_cast<std::size_t>(g)].x;
    const float *u = given.u_m_s + x, *v = given.v_m_s + x;
    const auto at = static_cast<std::size_t>(g) * kGroupCells;
    const float* share = points.share.data() + at;
    std::int32_t* __restrict column = points.column.data() + at;
    std::int32_t* __restrict row = points.row.data() + at;
    std::int32_t* __restrict moves = out.choice.data() + at;
    float* __restrict fx = out.fx.data() + at;
    float* __restrict fy = out.fy.data() + at;
    PENTIMENTO_INDEPENDENT
    for (int i = 0; i < kGroupCells; ++i) {
      const float own_x = static_cast<float>(x + i);
      const float px = std::min(std::max(own_x - share[i] * u[i] * cells_per_u, 0.0f), last_x);
      const float py = std::min(std::max(own_y - share[i] * v[i] * cells_per_v, 0.0f), last_y);
      const int x0 = static_cast<int>(px), y0 = static_cast<int>(py);
      fx[i] = px - static_cast<float>(x0);
      fy[i] = py - static_cast<float>(y0);
      column[i] = x0 - (x + i);
      row[i] = y0 - y;
      moves[i] = (u[i] != 0 ? kMovesBit : 0) | (v[i] != 0 ? kMovesBit : 0);
    }
  }
}

// Places that points of a group have, seen from that of one of them: a bit for each distance up to
// kMostApart, one more at either end for all beyond, and the same for rows times kRowsBy.
constexpr int kMostApart = kWideSide - 2;
constexpr int kPlaces = 2 * kMostApart + 3;
constexpr std::int32_t kRowsBy = 1 << kPlaces;

inline std::int32_t place_bit(std::int32_t distance) {
  const std::int32_t not_less = std::max(distance, -kMostApart - 1);
  return 1 << (std::min(not_less, kMostApart + 1) + kMostApart + 1);
}

/// The places of all cells that move, from column and row of one of them.
PENTIMENTO_KERNEL
std::int32_t find_places(const std::int32_t* column, const std::int32_t* row,
                         const std::int32_t* moves, std::int32_t one_column, std::int32_t one_row) {
  std::int32_t all = 0;
  for (int i = 0; i < kGroupCells; ++i) {
    const std::int32_t of_cell =
        place_bit(column[i] - one_column) + kRowsBy * place_bit(row[i] - one_row);
    all |= moves[i] != 0 ? of_cell : 0;
  }
  return all;
}

/// Notes of each cell which columns and rows it gets paint from.
PENTIMENTO_KERNEL
void choose_cells(const std::int32_t* column, const std::int32_t* row, int shift_x, int shift_y,
                  std::int32_t* __restrict choice) {
  for (int i = 0; i < kGroupCells; ++i) {
    choice[i] |= (column[i] == shift_x ? kFirstColumnBit : 0) |
                 (column[i] == shift_x + 2 ? kThirdColumnBit : 0) |
                 (row[i] == shift_y ? kFirstRowBit : 0) |
                 (row[i] == shift_y + 2 ? kThirdRowBit : 0);
  }
}

/// The first of the places, and how many there are from it to the last: more than kMostApart + 1 if
/// any is beyond, for the one cell's own place is among them.
struct PlaceRange {
  int first = 0, count = 1;
};
PlaceRange range_of(std::int32_t places) {
  const auto bits = static_cast<std::uint32_t>(places & (kRowsBy - 1));
  const int first = std::countr_zero(bits), end = static_cast<int>(std::bit_width(bits));
  return {first - kMostApart - 1, end - first};
}

/// The group's first cell's first column, r rows below the first of its rows.
std::ptrdiff_t group_place(const NearRow& row, const NearGroup& group, int r) {
  return std::min(row.y + group.shift_y + r, row.grid.height - 1) * row.grid.stride + group.x +
         group.shift_x;
}

/// Finds which columns and rows hold the points of a group, or that too many do. `choice` says of
/// each cell whether it moves.
void find_side(const NearRow& row, const std::int32_t* columns, const std::int32_t* rows,
               NearGroup& group, const std::int32_t* choice) {
  int one = 0;
  while (one < kGroupCells && choice[one] == 0) ++one;
  PlaceRange across, down;
  if (one < kGroupCells) {
    const std::int32_t places = find_places(columns, rows, choice, columns[one], rows[one]);
    across = range_of(places);
    down = range_of(places / kRowsBy);
    group.shift_x = columns[one] + across.first;
    group.shift_y = rows[one] + down.first;
  } else {  // Where nothing moves, any columns do that the canvas has.
    group.shift_x = -1;
    group.shift_y = 0;
  }
  group.side = std::max(kNearSide, std::max(across.count, down.count) + 1);
  const int last_x = group.x + group.shift_x + kGroupCells - 1 + group.side - 1;
  if (group.side > kWideSide || group.x + group.shift_x < 0 || last_x >= row.grid.width)
    group.side = 0;
}

}  // namespace

void find_near(const StepConstants& k, const NearRow& row, NearDepartures& out) {
  FoundPoints points;
  if (row.occupied == nullptr)
    points.share.fill(1);
  else
    for (int g = 0; g < out.groups; ++g)
      find_shares(row.layer, row.occupied + out.group[static_cast<std::size_t>(g)].x,
                  points.share.data() + static_cast<std::size_t>(g) * kGroupCells);
  find_points(k, row, out, points);
  for (int g = 0; g < out.groups; ++g) {
    NearGroup& group = out.group[static_cast<std::size_t>(g)];
    const auto first = static_cast<std::size_t>(g) * kGroupCells;
    const std::int32_t *columns = points.column.data() + first, *rows = points.row.data() + first;
    std::int32_t* choice = out.choice.data() + first;
    find_side(row, columns, rows, group, choice);
    if (group.side == 0) continue;
    choose_cells(columns, rows, group.shift_x, group.shift_y, choice);
    for (int r = 0; r < kWideSide; ++r)
      group.from[static_cast<std::size_t>(r)] = group_place(row, group, r);
    group.ahead = group_place(row, group, kNearSide - 1 + kRowsAhead);
  }
}

}  // namespace pentimento::paper

#pragma once
// What cells beside one another get from cells beside one another, as nearly all do: their
// departure points lie between the same three columns and rows, seen from each cell. Then vectors
// read the nine cells there and choose four. The same bits as cell by cell (departure.h).

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/fluid/paper/departure.h"
#include "core/fluid/paper/grid_rows.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

inline constexpr int kTogether = 64;       // cells of a row, at most
inline constexpr int kLeastTogether = 16;  // where the points of more lie too far apart

/// Where the paint of some cells of a row came from.
struct NearDepartures {
  // The first of the three columns and of the three rows, seen from each cell.
  int shift_x = 0, shift_y = 0;
  // Of each cell: the column and the row before its departure point, seen from the cell, and the
  // fractions from there; whether anything moves.
  std::array<std::int32_t, kTogether> column, row, moves;
  std::array<float, kTogether> fx, fy;
};

/// What is known of the cells [x, x + n) of row y. All pointers point at cell x.
struct NearCells {
  int x = 0, y = 0, n = 0;       // n at most kTogether
  int last_x = 0, last_y = 0;    // of the canvas
  const float* u_m_s = nullptr;  // velocity of the surface
  const float* v_m_s = nullptr;
  const float* share = nullptr;  // of that velocity
};

/// Finds the departure points. Returns false if they lie further apart than three columns and rows,
/// or these lie beyond the canvas's columns.
bool find_near(const StepConstants& k, const NearCells& cells, NearDepartures& out);

/// A plane around some cells of a row. All pointers point at the first cell, but for the shift.
struct NearRows {
  Rows from;          // the three rows that the departure points lie in
  const float* here;  // the cells' own row, without the shift
};

/// Row y of a plane from x on, and the rows that the departure points lie in.
inline NearRows rows_near(const Field<float>& plane, int x, int y,
                          const NearDepartures& departures) {
  const int last = plane.height() - 1;
  const auto from = [&](int row) {
    return plane.row(std::min(y + departures.shift_y + row, last)) + x + departures.shift_x;
  };
  return {{from(0), from(1), from(2)}, plane.row(y) + x};
}

/// The value beside cell i of the three rows, in row and column 0, 1 or 2.
inline float value_near(const NearRows& plane, int i, int row, int column) {
  const float* from = row == 0 ? plane.from.above : row == 1 ? plane.from.here : plane.from.below;
  return from[i + column];
}

/// interpolate() at the departure point of cell i, among nine cells: value(row, column).
template <typename Value>
inline float interpolate_near(const NearDepartures& d, int i, const Value& value) {
  const auto at = static_cast<std::size_t>(i);
  const bool first_columns = d.column[at] == d.shift_x, first_rows = d.row[at] == d.shift_y;
  const float top_0 = first_rows ? value(0, 0) : value(1, 0);
  const float top_1 = first_rows ? value(0, 1) : value(1, 1);
  const float top_2 = first_rows ? value(0, 2) : value(1, 2);
  const float bottom_0 = first_rows ? value(1, 0) : value(2, 0);
  const float bottom_1 = first_rows ? value(1, 1) : value(2, 1);
  const float bottom_2 = first_rows ? value(1, 2) : value(2, 2);
  const float top = mix(first_columns ? top_0 : top_1, first_columns ? top_1 : top_2, d.fx[at]);
  const float bottom =
      mix(first_columns ? bottom_0 : bottom_1, first_columns ? bottom_1 : bottom_2, d.fx[at]);
  return mix(top, bottom, d.fy[at]);
}

/// near(x, n), or if that returns false the same for each half of the cells, down to
/// kLeastTogether.
template <typename Near, typename Plainly>
void near_or_plainly(int x, int n, const Near& near, const Plainly& plainly) {
  if (near(x, n)) return;
  if (n <= kLeastTogether) return plainly(x, x + n);
  near_or_plainly(x, n / 2, near, plainly);
  near_or_plainly(x + n / 2, n - n / 2, near, plainly);
}

/// Goes along cells of a row: near(x, n) for up to `together` cells that have neighbours on both
/// sides, fewer where it returns false, and plainly(begin, end) for the others and where near()
/// returns false for few.
template <typename Near, typename Plainly>
void for_near_cells(Columns cells, int width, int together, Near near, Plainly plainly) {
  const int first = std::min(std::max(cells.begin, 1), cells.end);
  const int last = std::max(std::min(cells.end, width - 1), first);
  if (cells.begin < first) plainly(cells.begin, first);
  for (int x = first; x < last; x += together) {
    near_or_plainly(x, std::min(together, last - x), near, plainly);
  }
  if (last < cells.end) plainly(last, cells.end);
}

}  // namespace pentimento::paper

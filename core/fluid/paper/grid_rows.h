#pragma once
// How the kernels of this folder read the grid: a row with its two neighbour rows, and a range of
// columns. At the canvas's edge the edge cell itself takes the place of the missing neighbour. So
// there is no gradient (R16), and no flux either, for the normal velocity of edge cells is 0.

#include <algorithm>
#include <array>

#include "core/base/field.h"

namespace pentimento::paper {

/// Cells [begin, end) of a row.
struct Columns {
  int begin = 0, end = 0;
  bool empty() const { return begin >= end; }
  std::size_t count() const { return empty() ? 0 : static_cast<std::size_t>(end - begin); }
};

/// The smallest range that holds both.
inline Columns hull(Columns a, Columns b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

/// The range with one cell more on either side, within the width.
inline Columns widened(Columns c, int width) {
  if (c.empty()) return c;
  return {std::max(c.begin - 1, 0), std::min(c.end + 1, width)};
}

/// The cells of `all` before and behind those that are in `kept`, too.
inline std::array<Columns, 2> around(Columns kept, Columns all) {
  const int middle = kept.empty() ? all.end : std::clamp(kept.begin, all.begin, all.end);
  const int behind = kept.empty() ? all.end : std::max(kept.end, all.begin);
  return {Columns{all.begin, middle}, Columns{behind, all.end}};
}

/// Row y of a plane with the rows above and below it.
struct Rows {
  const float* above;
  const float* here;
  const float* below;
};

inline Rows rows_at(const Field<float>& f, int y) {
  return {f.row(std::max(y - 1, 0)), f.row(y), f.row(std::min(y + 1, f.height() - 1))};
}

/// Calls at_edge(x, left, right) for cells at the canvas's edge and inside(begin, end) for those
/// between, which have both neighbours.
template <typename AtEdge, typename Inside>
void for_edges_and_inside(Columns cells, int width, AtEdge at_edge, Inside inside) {
  int x = cells.begin;
  if (x == 0 && x < cells.end) {
    at_edge(0, 0, std::min(1, width - 1));
    ++x;
  }
  const int inner_end = std::min(cells.end, width - 1);
  if (x < inner_end) inside(x, inner_end);
  x = std::max(x, inner_end);
  if (x < cells.end) at_edge(x, x - 1, x);
}

/// Calls body(x, left, right) for the cells of a row; left and right are the neighbours' columns.
template <typename Body>
void for_cells(Columns cells, int width, Body body) {
  for_edges_and_inside(cells, width, body, [&](int begin, int end) {
    for (int x = begin; x < end; ++x) body(x, x - 1, x + 1);
  });
}

}  // namespace pentimento::paper

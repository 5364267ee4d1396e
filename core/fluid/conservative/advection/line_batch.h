#pragma once
// Line batches: a rectangle of cells that moves along one axis. It is a run of a row that moves
// along x, or a strip of columns that moves along y. In a flat array, the neighbours of a cell
// along the axis lie step() apart.

#include <algorithm>

#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/tiles/wet_cells.h"

namespace pentimento::conservative {

struct LineBatch {
  CellBox box;
  Axis axis = Axis::kX;
  int width() const { return box.x1 - box.x0; }
  int height() const { return box.y1 - box.y0; }
  int cells() const { return width() * height(); }
  int step() const { return axis == Axis::kX ? 1 : width(); }
};

/// The first column after the sleep tile of column x.
inline int end_of_tile(int x, int tile_width) {
  return (x / tile_width + 1) * tile_width;
}

/// Calls body(first, n, x, y) for each row of inner edges. The edges [first, first + n) lie between
/// the cells [first - step, ...) and [first, ...); (x, y) is the cell before the first of them. The
/// two end edges of a line are walls.
template <typename Body>
void for_inner_edges(const LineBatch& b, const Body& body) {
  if (b.axis == Axis::kX) {
    if (b.width() > 1) body(1, b.width() - 1, b.box.x0, b.box.y0);
  } else {
    for (int r = 1; r < b.height(); ++r) body(r * b.width(), b.width(), b.box.x0, b.box.y0 + r - 1);
  }
}

/// Calls body(begin, end, batch_at) in parallel: for each k in [begin, end), batch_at(k) is a batch
/// of wet cells that moves along y row by row, as wide as WetCells::boxes().
template <typename Body>
void for_wide_batches(const WetCells& wet, const Threads& threads, const Body& body) {
  const std::vector<CellBox>& boxes = wet.boxes();
  threads.for_ranges(0, static_cast<int>(boxes.size()), 1, [&](int begin, int end) {
    body(begin, end, [&](int k) {
      return LineBatch{boxes[static_cast<std::size_t>(k)], Axis::kY};
    });
  });
}

}  // namespace pentimento::conservative

#pragma once
// Line batches: a rectangle of cells as the flat array that the remap works on (remap_plan.h). It
// is a run of a row that moves along x, or a strip of columns that moves along y.

#include <algorithm>

#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/remap_row.h"
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

/// Copies the batch's cells of a plane (anything with row(y)) to or from a flat array.
template <typename Plane>
void load_batch(const LineBatch& b, const Plane& plane, float* out) {
  constexpr int kAhead = 12;  // rows of a strip lie pages apart: fetch them early
  for (int y = b.box.y0; y < b.box.y1; ++y, out += b.width()) {
    if (y + kAhead < b.box.y1) {
      const float* ahead = plane.row(y + kAhead) + b.box.x0;
      __builtin_prefetch(ahead);
      __builtin_prefetch(ahead + b.width() - 1);
    }
    std::copy_n(plane.row(y) + b.box.x0, b.width(), out);
  }
}
template <typename Plane>
void store_batch(const LineBatch& b, const float* in, Plane& plane) {
  for (int y = b.box.y0; y < b.box.y1; ++y, in += b.width())
    std::copy_n(in, b.width(), plane.row(y) + b.box.x0);
}

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
/// of wet cells that moves along `axis`. Along y it is one sleep tile wide.
template <typename Body>
void for_batches(const WetCells& wet, Axis axis, const Threads& threads, const Body& body) {
  std::vector<CellBox> boxes;
  if (axis == Axis::kX) {
    for (const Run& r : wet.runs()) boxes.push_back({r.x0, r.x1, r.y, r.y + 1});
  } else {
    for (const CellBox& b : wet.boxes())
      for (int x = b.x0; x < b.x1; x = end_of_tile(x, wet.tile_width()))
        boxes.push_back({x, std::min(end_of_tile(x, wet.tile_width()), b.x1), b.y0, b.y1});
  }
  threads.for_ranges(0, static_cast<int>(boxes.size()), 8, [&](int begin, int end) {
    body(begin, end, [&](int k) { return LineBatch{boxes[static_cast<std::size_t>(k)], axis}; });
  });
}

/// The same for batches that move along y row by row, as wide as WetCells::boxes().
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

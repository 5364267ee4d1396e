#pragma once
// Line batches: a rectangle of cells as the flat array that the remap works on (remap_plan.h). It
// is a run of a row that moves along x, or a strip of columns that moves along y.

#include <algorithm>

#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/remap_row.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"

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

/// Calls body(begin, end, batch_at) in parallel: for each k in [begin, end), batch_at(k) is an
/// awake batch that moves along `axis`.
template <typename Body>
void for_batches(const SleepTiles& tiles, Axis axis, const Threads& threads, const Body& body) {
  if (axis == Axis::kX) {
    const auto& runs = tiles.runs();
    threads.for_ranges(0, static_cast<int>(runs.size()), 8, [&](int begin, int end) {
      body(begin, end, [&](int k) {
        const Run& r = runs[static_cast<std::size_t>(k)];
        return LineBatch{{r.x0, r.x1, r.y, r.y + 1}, axis};
      });
    });
  } else {
    const auto& strips = tiles.strips();
    threads.for_ranges(0, static_cast<int>(strips.size()), 1, [&](int begin, int end) {
      body(begin, end, [&](int k) { return LineBatch{strips[static_cast<std::size_t>(k)], axis}; });
    });
  }
}

/// The same for batches that move along y row by row. Such a batch is strips side by side that
/// begin and end in the same rows, up to 128 columns together, so that its window of rows fits into
/// the cache of a core.
template <typename Body>
void for_wide_batches(const SleepTiles& tiles, const Threads& threads, const Body& body) {
  constexpr int kWidth = 128;
  std::vector<CellBox> wide;
  for (const CellBox& strip : tiles.strips()) {
    const auto same = std::find_if(wide.begin(), wide.end(), [&](const CellBox& b) {
      return b.x1 == strip.x0 && b.y0 == strip.y0 && b.y1 == strip.y1 && strip.x1 - b.x0 <= kWidth;
    });
    if (same == wide.end())
      wide.push_back(strip);
    else
      same->x1 = strip.x1;
  }
  threads.for_ranges(0, static_cast<int>(wide.size()), 1, [&](int begin, int end) {
    body(begin, end, [&](int k) { return LineBatch{wide[static_cast<std::size_t>(k)], Axis::kY}; });
  });
}

}  // namespace pentimento::conservative

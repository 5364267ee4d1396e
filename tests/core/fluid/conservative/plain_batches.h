#pragma once
// Batches of cells as flat arrays, which the plain twins of moving paint and momentum work on.

#include <algorithm>

#include "core/fluid/conservative/advection/line_batch.h"

namespace pentimento::conservative {

/// Copies the batch's cells of a plane (anything with row(y)) to or from a flat array.
template <typename Plane>
void load_batch(const LineBatch& b, const Plane& plane, float* out) {
  for (int y = b.box.y0; y < b.box.y1; ++y, out += b.width())
    std::copy_n(plane.row(y) + b.box.x0, b.width(), out);
}
template <typename Plane>
void store_batch(const LineBatch& b, const float* in, Plane& plane) {
  for (int y = b.box.y0; y < b.box.y1; ++y, in += b.width())
    std::copy_n(in, b.width(), plane.row(y) + b.box.x0);
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

}  // namespace pentimento::conservative

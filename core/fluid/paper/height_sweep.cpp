#include "core/fluid/paper/height_sweep.h"

#include "core/base/kernel.h"

namespace pentimento::paper {

namespace {

/// The system of a row, the heights around it, and where the sweep goes.
struct SweptHeights {
  const float *centre, *left, *right, *up, *down;
  Rows height_m;
  float* out;
};

inline void sweep_height_cell(const SweptHeights& s, int x, int l, int r) {
  s.out[x] = s.centre[x] + (s.left[x] * s.height_m.here[l] + s.right[x] * s.height_m.here[r]) +
             (s.up[x] * s.height_m.above[x] + s.down[x] * s.height_m.below[x]);
}

PENTIMENTO_KERNEL
void sweep_height_cells(const SweptHeights& given, int begin, int end) {
  const SweptHeights rows = given;
  PENTIMENTO_INDEPENDENT
  for (int x = begin; x < end; ++x) sweep_height_cell(rows, x, x - 1, x + 1);
}

}  // namespace

void sweep_height_row(const Stencil& system, const Field<float>& height_m, int y, Columns cells,
                      float* out) {
  const SweptHeights rows{system.centre.row(y),
                          system.left.row(y),
                          system.right.row(y),
                          system.up.row(y),
                          system.down.row(y),
                          rows_at(height_m, y),
                          out};
  for_edges_and_inside(
      cells, height_m.width(), [&](int x, int l, int r) { sweep_height_cell(rows, x, l, r); },
      [&](int begin, int end) { sweep_height_cells(rows, begin, end); });
}

PENTIMENTO_KERNEL
void limit_height_row(const Field<float>& base_m, float max_medium_m, int y, Columns cells,
                      float* height_m) {
  const float* b = base_m.row(y);
  for (int x = cells.begin; x < cells.end; ++x)
    height_m[x] = std::min(std::max(height_m[x], b[x]), b[x] + max_medium_m);
}

}  // namespace pentimento::paper

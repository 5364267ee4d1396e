#include "core/fluid/paper/height_sweep.h"

#include "core/base/kernel.h"

namespace pentimento::paper {

void sweep_height_row(const Stencil& system, const Field<float>& height_m, int y, Columns cells,
                      float* out) {
  const Rows h = rows_at(height_m, y);
  const float *centre = system.centre.row(y), *left = system.left.row(y);
  const float *right = system.right.row(y), *up = system.up.row(y), *down = system.down.row(y);
  for_cells(cells, height_m.width(), [=](int x, int l, int r) {
    out[x] = centre[x] + (left[x] * h.here[l] + right[x] * h.here[r]) +
             (up[x] * h.above[x] + down[x] * h.below[x]);
  });
}

PENTIMENTO_KERNEL
void limit_height_row(const Field<float>& base_m, float max_medium_m, int y, Columns cells,
                      float* height_m) {
  const float* b = base_m.row(y);
  for (int x = cells.begin; x < cells.end; ++x)
    height_m[x] = std::min(std::max(height_m[x], b[x]), b[x] + max_medium_m);
}

}  // namespace pentimento::paper

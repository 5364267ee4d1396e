#pragma once
// The brush deposits paint on the canvas (R25-R27).

#include <cstdint>
#include <span>

#include "core/layers/layer_row.h"

namespace pentimento {

struct Deposit {
  float max_depth_m = 0;  // no deposit fills a cell beyond this
  std::uint32_t stroke_id = 0;
};

/// Deposits `paint` on the cells of a row.
///   d += paint[0], P_k += paint[1..] with the layer k of open_layer(); the id becomes the stroke's
///   sums = what the planes gained over the row, exactly (height first)
/// Where d would exceed max_depth_m, all of the cell's paint is scaled down; the rest stays in the
/// brush. Scheme: pointwise. Stability: keeps everything >= 0. Source: R25, R26, R27; A22.
/// Departs from it: nothing.
/// `paint`: `stride` floats per cell (height in m, amounts of the channels), scaled down where it
/// did not fit. Cells with no paint to deposit are left alone. `depth_m` and `stroke` have one
/// value per cell.
void deposit_row(const Deposit& deposit, const LayerRow& row, std::span<float> depth_m,
                 std::uint32_t* stroke, float* paint, int stride, std::span<double> sums);

}  // namespace pentimento

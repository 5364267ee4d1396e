#pragma once
// Blocks of factor x factor fine cells in a tile's plane: sums, factors, the interpolated field of
// factors. Pure functions on planes of `side` x `side` floats; `box` says which blocks there are.

#include <span>
#include <vector>

#include "core/detail/detail_layout.h"
#include "core/field.h"

namespace pentimento {

/// What a block of fine cells holds, as mean over its cells: `mean` has box.width() values a row.
/// Sums a row of a block in float, the rows in double: k <= 32 keeps it within 2e-6.
void block_means(const float* plane, int side, int factor, const GuideBox& box,
                 std::span<float> mean);

/// value *= r(x, y), r bilinear between the centres of the guide's cells.
///   Scheme: bilinear; constant beyond the guide's outermost centres. Stable: r >= 0 keeps
///   values >= 0. Source: decisions on the lock (docs/fidelity.md). Departs from it: nothing.
void scale_by_field(FieldView<const float> ratio, int factor, const GuideBox& box, float* plane,
                    int side);

/// value *= scale of the block (box.width() values a row).
void scale_blocks(std::span<const float> scale, int factor, const GuideBox& box, float* plane,
                  int side);

}  // namespace pentimento

#pragma once
// Blocks of factor x factor fine cells side by side in a tile's plane: their means, factors per
// block, a field of factors interpolated between blocks. Pure functions on one row of blocks.

#include <span>

#include "core/base/field.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// Blocks side by side: `factor` rows of blocks * factor cells, `stride` apart. At most
/// kMostTileSide cells wide.
struct BlockRow {
  float* first = nullptr;
  std::ptrdiff_t stride = 0;
  int factor = 1;
  int blocks = 0;
  int cells() const { return blocks * factor; }
};

/// A row of guide cells and its neighbours above and below, where they lie in the guide's planes.
struct RatioRows {
  const float* above = nullptr;
  const float* here = nullptr;
  const float* below = nullptr;
  int x = 0;      // the first of the blocks
  int width = 0;  // of the guide: beyond its first and last value they are repeated
};

/// The blocks of a strip in a plane of its tile.
BlockRow block_row(float* plane, const DetailLayout& layout, const BlockStrip& strip);
/// The rows around row y of a plane of the guide, for blocks from x on.
RatioRows ratio_rows(const Field<float>& plane, int x, int y);

/// What each block holds, as mean over its cells.
/// Sums a column of a block in float, the columns in double: k <= 32 keeps it within 2e-6.
void block_means(const BlockRow& row, std::span<float> mean);

/// value *= r(x, y), r bilinear between the centres of the guide's cells; `mean`: of the blocks
/// afterwards.
///   Scheme: bilinear; constant beyond the guide's outermost centres. Stable: r >= 0 keeps
///   values >= 0. Source: decisions on the lock (docs/fidelity.md). Departs from it: nothing.
void scale_by_field(const RatioRows& ratio, const BlockRow& row, std::span<float> mean);

/// value *= scale of the block.
void scale_blocks(std::span<const float> scale, const BlockRow& row);

}  // namespace pentimento

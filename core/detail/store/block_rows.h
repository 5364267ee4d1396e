#pragma once
// Pure functions on a row of blocks, of factor x factor fine cells each, in a plane of a tile: the
// means of the blocks, scaling block by block, and scaling by a field of ratios that is
// interpolated between blocks.

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
  int x = 0;      // column of the first block on the guide
  int width = 0;  // of the guide; its first and last value repeat beyond it
};

/// The blocks of a strip in a plane of its tile.
BlockRow block_row(float* plane, const DetailLayout& layout, const BlockStrip& strip);
/// The rows around row y of a plane of the guide, for blocks from x on.
RatioRows ratio_rows(const Field<float>& plane, int x, int y);

/// The mean of each block over its cells. Sums each column of a block in float and the columns in
/// double, which keeps the error within 2e-6 for factors up to 32.
void block_means(const BlockRow& row, std::span<float> mean);

/// value *= r(x, y), r bilinear between the centres of the guide's cells. `mean` gets the blocks'
/// means afterwards.
///   Scheme: bilinear; constant beyond the guide's outermost centres. Stable: r >= 0 keeps
///   values >= 0. Source: decisions on the lock (docs/fidelity.md). Departs from it: nothing.
void scale_by_field(const RatioRows& ratio, const BlockRow& row, std::span<float> mean);

/// value *= scale[block].
void scale_blocks(std::span<const float> scale, const BlockRow& row);

}  // namespace pentimento

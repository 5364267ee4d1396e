#pragma once
// Pure functions on a row of blocks, of factor x factor fine cells each, in a plane of a tile: the
// means of the blocks, scaling block by block, and scaling by a field of ratios that is
// interpolated between blocks.

#include <array>
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

/// The ratios of blocks side by side, and of those above and below. Each row may be read from one
/// block before its first to one after its last.
struct RatioRows {
  const float* above = nullptr;
  const float* here = nullptr;
  const float* below = nullptr;
};

/// The ratios of blocks side by side and of all blocks around them: three rows, one block longer at
/// either end.
class RatiosAround {
 public:
  float& at(int row, int block) { return value_[index(row)][index(block + 1)]; }
  float at(int row, int block) const { return value_[index(row)][index(block + 1)]; }
  /// As rows that begin at a block.
  RatioRows from(int block) const {
    return {&value_[0][index(block + 1)], &value_[1][index(block + 1)],
            &value_[2][index(block + 1)]};
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  std::array<std::array<float, kMostTileSide + 2>, 3> value_;
};

/// The blocks of a strip in a plane of its tile.
BlockRow block_row(float* plane, const DetailLayout& layout, const BlockStrip& strip);

/// Values of a plane of the guide at the blocks of a strip and around it. Beyond the guide, its
/// outermost values repeat.
void read_around(const Field<float>& plane, const BlockStrip& strip, RatiosAround& out);

/// The mean of each block over its cells. Sums each column of a block in float and the columns in
/// double, which keeps the error within 2e-6 for factors up to 32.
void block_means(const BlockRow& row, std::span<float> mean);

/// value *= r(x, y), r bilinear between the centres of the guide's cells. `mean` gets the blocks'
/// means afterwards.
///   Scheme: bilinear. Stable: r >= 0 keeps
///   values >= 0. Source: decisions on the lock (docs/fidelity.md). Departs from it: nothing.
void scale_by_field(const RatioRows& ratio, const BlockRow& row, std::span<float> mean);

/// value *= scale[block].
void scale_blocks(std::span<const float> scale, const BlockRow& row);

}  // namespace pentimento

#pragma once
// By which ratios listed blocks of the guide are off, in several planes. All other blocks have the
// ratio 1.

#include <cstdint>
#include <span>
#include <vector>

#include "core/base/field.h"
#include "core/detail/store/block_rows.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// Lists of blocks are made by one thread. Then several threads may read, and write the ratios of
/// different blocks or planes.
class BlockRatios {
 public:
  explicit BlockRatios(const DetailLayout& layout)
      : place_(layout.guide().width, layout.guide().height) {}

  /// Forgets all blocks.
  void clear();
  /// Lists the blocks of a strip, in which no block is listed yet. They get the next indices from 0
  /// on.
  void add(const BlockStrip& strip);
  /// Sets all ratios of `planes` planes to 1.
  void reset(std::size_t planes) { ratio_.assign(planes * (blocks_ + 1), 1.0f); }

  std::size_t blocks() const { return blocks_; }
  /// Of `count` blocks of a plane, from the index `first` on.
  std::span<float> of(std::size_t plane, std::size_t first, std::size_t count) {
    return {ratio_.data() + plane * (blocks_ + 1) + 1 + first, count};
  }
  /// The blocks of a strip and those around it. Beyond the guide, its outermost blocks repeat.
  void read(std::size_t plane, const BlockStrip& strip, RatiosAround& out) const;

 private:
  Field<std::int32_t> place_;  // per cell of the guide: its block's index + 1; 0 if not listed
  std::vector<BlockStrip> strips_;
  std::size_t blocks_ = 0;
  std::vector<float> ratio_;  // plane after plane: 1, for what is not listed, then the blocks
};

}  // namespace pentimento

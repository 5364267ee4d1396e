#pragma once
// Which blocks the brush has just released: their paint is fresh, and the brush does not touch it
// any more.

#include <cstdint>
#include <vector>

#include "core/base/field.h"
#include "core/base/vec.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_layout.h"

namespace pentimento {

struct ReleasedBlock {
  BlockStrip at;  // one block
  Vec2f way;      // of the last stamp over it: a unit vector, or (0, 0) for a tap
};

/// A block that a stamp was over and that is not released yet.
struct StampedBlock {
  int x = 0, y = 0;  // of the guide
  Vec2f way;         // of the last stamp
  bool now = false;  // whether in this step; else in the step before
  friend bool operator==(const StampedBlock&, const StampedBlock&) = default;
};

/// Not thread-safe.
class ReleasedBlocks {
 public:
  explicit ReleasedBlocks(const DetailLayout& layout)
      : layout_(layout),
        mark_(layout.guide().width, layout.guide().height),
        way_(layout.guide().width, layout.guide().height) {}

  /// Notes that a stamp was over the cells of `box`, which lies on the canvas. `way`: the stamp's
  /// direction, a unit vector or (0, 0).
  void stamped(const CellBox& box, Vec2f way);
  /// Ends a step. Returns the blocks that were stamped in the step before and not in this one, by
  /// rows.
  std::vector<ReleasedBlock> step();
  void clear();
  /// The blocks that a later step() will release, by rows.
  std::vector<StampedBlock> stamped() const;
  /// Goes on with what stamped() gave. The blocks lie on the canvas.
  void restore(const std::vector<StampedBlock>& stamped);

 private:
  enum Age : std::uint8_t { kNone, kBefore, kNow };
  struct Cell {
    int y, x;
    auto operator<=>(const Cell&) const = default;
  };

  DetailLayout layout_;
  Field<std::uint8_t> mark_;
  Field<Vec2f> way_;
  std::vector<Cell> cells_;  // that have a mark
};

}  // namespace pentimento

#pragma once
// Which cells of the guide the brush has just left: fresh paint that nothing works on any more.

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

/// A block that a stamp was over and that has not been left yet.
struct StampedBlock {
  int x = 0, y = 0;  // of the guide
  Vec2f way;         // of the last stamp
  bool now = false;  // in the step that has not ended, else in the one before
  friend bool operator==(const StampedBlock&, const StampedBlock&) = default;
};

/// Not thread-safe.
class ReleasedBlocks {
 public:
  explicit ReleasedBlocks(const DetailLayout& layout)
      : layout_(layout),
        mark_(layout.guide().width, layout.guide().height),
        way_(layout.guide().width, layout.guide().height) {}

  /// A stamp was over the cells of `box`, which lies on the canvas, on its way along `way`.
  void stamped(const CellBox& box, Vec2f way);
  /// Ends a step. The cells that were stamped before it and not in it, by rows.
  std::vector<ReleasedBlock> step();
  void clear();
  /// What step() will tell of later, by rows.
  std::vector<StampedBlock> stamped() const;
  /// Takes up what stamped() gave; the blocks lie on the canvas.
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

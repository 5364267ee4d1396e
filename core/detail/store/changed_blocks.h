#pragma once
// Which cells of the guide have changed since they were last looked at, as one span per row of each
// tile. So the work after a stroke is in proportion to the stroke's own area.

#include <cstdint>
#include <vector>

#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// Guide cells [x0, x1) of row y, all in one tile.
struct BlockStrip {
  int tile = 0;
  int y = 0, x0 = 0, x1 = 0;
  int blocks() const { return x1 - x0; }
};

/// Not thread-safe.
class ChangedBlocks {
 public:
  explicit ChangedBlocks(const DetailLayout& layout);

  /// Adds the guide cells [x0, x1) of row y, cut to the canvas. If two parts are added to the same
  /// row of a tile, everything between them counts as changed too.
  void add(int y, int x0, int x1);
  void add(const CellBox& box);
  void clear();

  bool empty() const { return listed_.empty(); }
  bool has(int tile) const { return flag_[static_cast<std::size_t>(tile)] != 0; }
  /// The tiles with changes, ascending.
  std::vector<int> tiles() const;
  /// All changes: tile by tile, ascending, and row by row.
  std::vector<BlockStrip> strips() const;
  /// The smallest box around the changes in one tile.
  CellBox box(int tile) const;

 private:
  struct ChangedSpan {
    int x0 = 0, x1 = 0;
  };
  const ChangedSpan& span(int column, int y) const {
    return span_[static_cast<std::size_t>(column) *
                     static_cast<std::size_t>(layout_.guide().height) +
                 static_cast<std::size_t>(y)];
  }

  DetailLayout layout_;
  std::vector<ChangedSpan> span_;   // per column of tiles and row of the guide; x1 = 0: none
  std::vector<std::uint8_t> flag_;  // per tile: has a span
  std::vector<int> listed_;         // tiles with a span, in the order in which they came
};

}  // namespace pentimento

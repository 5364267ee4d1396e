#pragma once
// Which cells of the guide have changed since they were last looked at, as one span per row of each
// tile: what is done again after a stroke follows the stroke's own area.

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

  /// Adds guide cells [x0, x1) of row y; what lies beyond the canvas is cut off. Between two parts
  /// added to the same row of a tile everything counts as changed.
  void add(int y, int x0, int x1);
  void add(const CellBox& box);
  void clear();

  bool empty() const { return listed_.empty(); }
  bool has(int tile) const { return flag_[static_cast<std::size_t>(tile)] != 0; }
  /// Ascending.
  std::vector<int> tiles() const;
  /// Tile by tile, ascending, row by row.
  std::vector<BlockStrip> strips() const;
  /// What strips() has of one tile, as the smallest box around it.
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
  std::vector<ChangedSpan> span_;   // per column of tiles, per row of the guide; x1 = 0: nothing
  std::vector<std::uint8_t> flag_;  // per tile: has a span
  std::vector<int> listed_;         // those tiles, in the order they came
};

}  // namespace pentimento

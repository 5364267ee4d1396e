#pragma once
// Wet cells: the cells of awake tiles that hold paint, and those that paint may come to or be seen
// from in a part of a step. A quarter to a half of what is awake is bare canvas, in which nothing
// happens: its faces are closed, its velocities are 0, no solve changes it. A step leaves it out.
//
// Rows are taken four at a time and cells sixteen at a time, from multiples of both: runs are the
// same in all rows of a coarse node of the solver, and begin with a whole vector.

#include <vector>

#include "core/base/field.h"
#include "core/base/runs.h"
#include "core/base/threads.h"
#include "core/canvas/cell_box.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"

namespace pentimento::conservative {

class WetCells {
 public:
  /// Finds the cells of awake tiles that have paint, or are touched by the brush
  /// (SleepTiles::touched()), within `reach` cells along both axes. Gaps of less than
  /// kLeastGap cells in a row are found wet, too.
  void find(const SleepTiles& tiles, const Field<float>& depth_m, int reach,
            const Threads& threads);
  /// All cells of awake tiles.
  void find_all(const SleepTiles& tiles);

  /// The wet cells of each row, row after row, from left to right.
  const std::vector<Run>& runs() const { return runs_; }
  /// Boxes that cover them, for what moves along y: columns side by side, up to kMostColumns, of
  /// tiles that are awake in the same rows. What lies beside a box in its columns is bare.
  const std::vector<CellBox>& boxes() const { return boxes_; }
  /// Columns of a sleep tile.
  int tile_width() const { return tile_width_; }

  static constexpr int kLeastGap = 64;
  static constexpr int kMostColumns = 128;  // so that a window of rows fits into a core's cache

 private:
  /// Rows with the same runs.
  struct RowBand {
    int y0 = 0, y1 = 0;
    std::vector<Run> runs;  // in its first row
  };
  void list_bands(const SleepTiles& tiles);
  void list_runs();
  void list_boxes(const SleepTiles& tiles);
  void cover(const CellBox& columns);

  int tile_width_ = 0;
  std::vector<RowBand> bands_;
  std::vector<Run> runs_;
  std::vector<CellBox> boxes_;
};

/// Calls body(y, x0, x1) for the cells of `a` that are not in `b`. Both have their runs row after
/// row, from left to right.
template <typename Body>
void for_cells_left(const std::vector<Run>& a, const std::vector<Run>& b, const Body& body) {
  std::size_t k = 0;
  for (const Run& r : a) {
    while (k < b.size() && (b[k].y < r.y || (b[k].y == r.y && b[k].x1 <= r.x0))) ++k;
    int x = r.x0;
    for (std::size_t i = k; i < b.size() && b[i].y == r.y && b[i].x0 < r.x1; ++i) {
      if (x < b[i].x0) body(r.y, x, b[i].x0);
      x = b[i].x1;
    }
    if (x < r.x1) body(r.y, x, r.x1);
  }
}

}  // namespace pentimento::conservative

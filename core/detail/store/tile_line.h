#pragma once
// Lines of fine cells across neighbouring tiles. Some lines side by side are loaded from the tiles
// into one array, moved along their axis, and stored back.

#include <vector>

#include "core/base/transpose.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// Tiles side by side (kX) or one below the other (kY). All have changed blocks; some may lack
/// planes or not exist.
struct TileRun {
  Axis axis = Axis::kX;
  std::vector<int> tiles;
  CellBox box;  // of the guide, all tiles together
  /// Number of blocks along the axis, and across it.
  int length() const { return axis == Axis::kX ? box.width() : box.height(); }
  int breadth() const { return axis == Axis::kX ? box.height() : box.width(); }
};

/// The runs of the tiles that have blocks in the list.
std::vector<TileRun> runs_of(const DetailLayout& layout, const ChangedBlocks& blocks, Axis axis);

/// Fine cells of lines side by side: of the lines from `line` on, counted across the run, the cells
/// from `begin` on, counted along it.
struct LineRange {
  int line = 0, lines = 0;
  int begin = 0, cells = 0;
};

/// Loads the lines, one row of `out` each. Absent planes read as 0.
void load_lines(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, const LineRange& range,
                const FloatBlock<float>& out);
/// Stores lines again. Where the plane is absent, nothing is stored.
void store_lines(DetailCanvas& canvas, const TileRun& run, const WetPlane& q,
                 const LineRange& range, const FloatBlock<const float>& in);
/// Whether any tile of the run has the plane.
bool has_plane(DetailCanvas& canvas, const TileRun& run, const WetPlane& q);

}  // namespace pentimento

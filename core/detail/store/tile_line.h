#pragma once
// Lines of fine cells across neighbouring tiles. A line is loaded from the tiles into one array,
// moved along its axis, and stored back.

#include <span>
#include <vector>

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

/// Loads fine cells of line `line`, counted across the run, from cell `begin` of the run on. Absent
/// planes read as 0.
void load_line(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, int line, int begin,
               std::span<float> out);
/// Stores fine cells of a line again. Where the plane is absent, nothing is stored.
void store_line(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, int line, int begin,
                std::span<const float> in);
/// Whether any tile of the run has the plane.
bool has_plane(DetailCanvas& canvas, const TileRun& run, const WetPlane& q);

}  // namespace pentimento

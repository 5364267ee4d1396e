#pragma once
// Lines of fine cells across neighbouring tiles: what moves along an axis is loaded from the tiles
// into one array, and stored back.

#include <span>
#include <vector>

#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// Tiles side by side (kX) or one below the other (kY), all with blocks in the list; may lack
/// planes or not exist.
struct TileRun {
  Axis axis = Axis::kX;
  std::vector<int> tiles;
  CellBox box;  // of the guide, all tiles together
  /// Blocks along the axis, and across it.
  int length() const { return axis == Axis::kX ? box.width() : box.height(); }
  int breadth() const { return axis == Axis::kX ? box.height() : box.width(); }
};

std::vector<TileRun> runs_of(const DetailLayout& layout, const ChangedBlocks& blocks, Axis axis);

/// Fine cells [begin, end) of line `line` (counted across the run); absent planes read as 0.
void load_line(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, int line, int begin,
               std::span<float> out);
/// Where the plane is absent nothing is stored.
void store_line(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, int line, int begin,
                std::span<const float> in);
/// Whether any tile of the run has the plane.
bool has_plane(DetailCanvas& canvas, const TileRun& run, const WetPlane& q);

}  // namespace pentimento

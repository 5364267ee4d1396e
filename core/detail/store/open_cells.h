#pragma once
// The edge of a stroke inside a block. The guide opens a layer for a whole cell at once. Of the
// fine cells only those that the tip touches follow, each when the tip touches it. So a stroke over
// other strokes has an edge of its own instead of the guide's staircase.

#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// Gives the tables memory, so that cells can wait for the tip from now on.
void make_openable(OpenCells& open, const DetailLayout& layout);

/// Notes that the guide has opened a layer in its cell (x, y) for another stroke: all fine cells of
/// the block now wait for the tip. Call make_openable() first, except on a canvas of one layer,
/// where nothing opens.
void await_tip(DetailTile& tile, const DetailLayout& layout, int x, int y, int layers,
               const LayerOpening& opening);

/// What opening does in the fine cells of block (x, y).
const LayerOpening& opening_in(const DetailTile& tile, const DetailLayout& layout, int x, int y);

/// Whether the fine cells of block (x, y) have the same layers as the guide's cell. If not, the
/// block is mismatched, and only sums over layers can be compared.
bool layers_correspond(const DetailTile& tile, const DetailLayout& layout, int x, int y);

}  // namespace pentimento

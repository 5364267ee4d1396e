#pragma once
// The edge of a stroke inside a block. The guide opens a layer for a whole cell at once; of the
// fine cells only those that the tip touches follow, each when it is touched, so that a stroke over
// other strokes has an edge of its own instead of the guide's staircase.

#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// There can be cells that wait from now on.
void make_openable(OpenCells& open, const DetailLayout& layout);

/// The guide has opened its cell (x, y), of `layers` layers, for another stroke: the cells of the
/// block wait. The tile is openable unless there is one layer only, which never opens.
void await_tip(DetailTile& tile, const DetailLayout& layout, int x, int y, int layers,
               const LayerOpening& opening);

/// Opens the fine cell (x, y) of the canvas, cell `cell` of `row`, unless it is open.
void open_cell(DetailTile& tile, const DetailLayout& layout, const LayerRow& row, int x, int y,
               int cell);

/// Whether the layers of all cells of the block (x, y) correspond to the guide's: if not, only the
/// sums over layers do.
bool layers_correspond(const DetailTile& tile, const DetailLayout& layout, int x, int y);

}  // namespace pentimento

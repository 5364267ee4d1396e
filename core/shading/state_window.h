#pragma once
// Packs parts of a canvas as texels. Cells outside the grid repeat its edge.

#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"
#include "core/shading/albedo_row.h"

namespace pentimento {

/// Colour of all paint, linear red, green and blue, and the depth of wet paint (m): four floats a
/// cell. `edges`: whether a cell at the edge of wet paint is covered in part only.
void pack_albedo(const CanvasSource& canvas, const AlbedoOptics& optics, EdgeCells edges,
                 const CellWindow& window, const Threads& threads, std::vector<float>& texels);
/// Height (m) and thickness of all paint, dry and wet (m): two floats a cell.
void pack_relief(const CanvasSource& canvas, const CellWindow& window, const Threads& threads,
                 std::vector<float>& texels);
/// Channels 4 plane .. 4 plane + 3, in all layers together: four floats a cell, 0 for those the
/// canvas has not.
void pack_amounts(const CanvasSource& canvas, int plane, const CellWindow& window,
                  const Threads& threads, std::vector<float>& texels);

}  // namespace pentimento

#pragma once
// Parts of a canvas as texels: four floats a cell, cells outside the grid repeating its edge.

#include <vector>

#include "core/canvas_source.h"

namespace pentimento {

/// The first three bands of the dry reflectance and the depth of wet paint (m).
void pack_ground(const CanvasSource& canvas, const CellWindow& window, std::vector<float>& texels);
/// Bands 4 texel .. 4 texel + 3 of the dry reflectance; 0 for those it has not.
void pack_bands(const CanvasSource& canvas, int texel, const CellWindow& window,
                std::vector<float>& texels);
/// Height (m) and thickness of all paint, dry and wet (m): two floats a cell.
void pack_relief(const CanvasSource& canvas, const CellWindow& window, std::vector<float>& texels);
/// Channels 4 plane .. 4 plane + 3 of `layer`; 0 for those it has not.
void pack_amounts(const CanvasSource& canvas, int layer, int plane, const CellWindow& window,
                  std::vector<float>& texels);

}  // namespace pentimento

#pragma once
// Parts of a canvas state as texels: four floats a cell, cells outside the grid repeating its edge.

#include <vector>

#include "core/canvas_state.h"

namespace pentimento {

/// A part of the grid; may reach over its edges.
struct CellWindow {
  int x = 0;
  int y = 0;
  int width = 0;
  int height = 0;
};

/// Dry reflectance RGB and the depth of wet paint (m). The state has three bands.
void pack_ground(const CanvasState& state, const CellWindow& window, std::vector<float>& texels);
/// Height (m) and thickness of all paint, dry and wet (m): two floats a cell.
void pack_relief(const CanvasState& state, const CellWindow& window, std::vector<float>& texels);
/// Channels 4 plane .. 4 plane + 3 of `layer`; 0 for those it has not.
void pack_amounts(const CanvasState& state, int layer, int plane, const CellWindow& window,
                  std::vector<float>& texels);

}  // namespace pentimento

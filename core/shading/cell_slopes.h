#pragma once
// Slopes of the relief in the middle of each cell, for pictures whose samples lie there. They are
// found on the processor, which reads rows in order; a shader would look up each neighbour.

#include <array>
#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"

namespace pentimento {

/// A part of the relief as pack_relief() packs it, and what lies around it.
struct PackedRelief {
  const std::vector<float>& texels;  // of the window and its border
  CellWindow window;                 // without the border
  int border = 1;                    // cells, >= 1
};

/// Four floats for each cell of the window: height (m), thickness of all paint (m), and the slopes
/// to the right and down, central differences of the height times `per_cell` (the relief's scale
/// over the cell's size, 1/m).
void pack_slopes(const PackedRelief& relief, const std::array<float, 2>& per_cell,
                 const Threads& threads, std::vector<float>& out);

}  // namespace pentimento

#pragma once
// Paint lifted from the canvas arrives in the reservoir.

#include <span>
#include <vector>

#include "core/brush/footprint.h"
#include "core/brush/reservoir.h"

namespace pentimento {

/// Paint lifted from the cells of a box: `stride` floats per cell, row by row, and its sums.
struct LiftedPaint {
  std::span<const float> paint;
  int stride = 4;
};

/// Memory that gather_lifted keeps between calls.
struct GatherScratch {
  std::vector<float> weight;     // per cell: how much texels reach for it
  std::vector<float> paint;      // per cell, divided by that
  std::vector<float> unreached;  // per component
};

/// Each cell's paint is divided among the texels near it, by tents about their centres; what no
/// texel reaches goes to all alike. So the reservoir gains, per area, just what the canvas lost.
/// The shares are geometry alone, equal for all components: the map is linear, and a mixture
/// arrives as the same mixture whatever the channels mean (A26).
void gather_lifted(const LiftedPaint& lifted, const TipPose& pose, const CellBox& box,
                   const CanvasGeometry& geometry, const Tip& tip, Reservoir& reservoir,
                   GatherScratch& scratch);

}  // namespace pentimento

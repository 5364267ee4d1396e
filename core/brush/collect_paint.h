#pragma once
// Paint lifted from the canvas arrives in the reservoir.

#include <span>
#include <vector>

#include "core/brush/reservoir.h"
#include "core/brush/tip_pose.h"

namespace pentimento {

/// The cells of a row of a box that the tip touches: [begin, end).
struct TouchedCells {
  int begin = 0, end = 0;
};

/// Paint lifted from the cells of a box: `stride` floats per cell, row by row.
struct PickedUpPaint {
  std::span<const float> paint;
  int stride = 4;
  std::span<const TouchedCells> rows;  // the others hold anything
};

/// Each cell's paint is divided among the tip's texels near it, by tents as wide as texels are
/// apart and never narrower than a cell; what reaches no texel goes to all alike. So the reservoir
/// gains, per area, just what the canvas lost. The shares are geometry alone, equal for all
/// components: the map is linear, and a mixture arrives as the same mixture whatever the channels
/// mean (A26).
void collect_picked_up(const PickedUpPaint& picked_up, const TipPose& pose, const FootprintBox& box,
                       const CanvasGeometry& geometry, const Tip& tip, Reservoir& reservoir);

}  // namespace pentimento

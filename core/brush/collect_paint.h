#pragma once
// Picked up paint arrives in the reservoir.

#include <span>
#include <vector>

#include "core/brush/reservoir.h"
#include "core/brush/tip_pose.h"
#include "core/brush/touched_cells.h"

namespace pentimento {

/// Paint picked up from the cells of a box: `stride` floats for each touched cell.
struct PickedUpPaint {
  std::span<const float> paint;
  int stride = 4;
  std::span<const TouchedCells> rows;  // of the box
};

/// Divides each cell's paint among the texels of the reservoir near it. The weights are tents as
/// wide as texels are apart, and never narrower than a cell. Paint that reaches no texel goes to
/// all texels alike. So the reservoir gains just what the canvas lost. The weights depend on
/// geometry alone and are the same for all components, so a mixture arrives as the same mixture,
/// whatever the channels mean (A26).
void collect_picked_up(const PickedUpPaint& picked_up, const TipPose& pose, const FootprintBox& box,
                       const CanvasGeometry& geometry, const Tip& tip, Reservoir& reservoir);

}  // namespace pentimento

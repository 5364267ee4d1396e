#pragma once
// Paint lifted from the canvas arrives in the reservoir.

#include <span>

#include "core/brush/footprint.h"
#include "core/brush/reservoir.h"

namespace pentimento {

/// Paint lifted from the cells of a box: `stride` floats per cell, row by row, and its sums.
struct LiftedPaint {
  std::span<const float> paint;
  int stride = 4;
  std::span<const double> sum;  // over the box: height, channels
};

/// Memory that gather_lifted keeps between calls.
struct GatherScratch {
  std::vector<float> paint;
  std::vector<double> sum;
};

/// Each texel takes what was lifted under its centre (bilinear between cells); then each component
/// is scaled so that the reservoir gains, per area, just what the canvas lost.
void gather_lifted(const LiftedPaint& lifted, const TipPose& pose, const CellBox& box,
                   const CanvasGeometry& geometry, const Tip& tip, Reservoir& reservoir,
                   GatherScratch& scratch);

}  // namespace pentimento

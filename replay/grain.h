#pragma once
// The grain of cold-pressed paper: smooth bumps of several sizes, in 0..1, a periodic function of
// the unit square. Reaches the state: own arithmetic only.

#include "core/field.h"
#include "replay/weave.h"

namespace pentimento {

/// Value noise: cubic-smoothed random lattices of 12, 24, 48 and 96 points across one repeat, each
/// half as high as the one before. A lattice finer than two cells fades out, so that the grain
/// stays the same painting's at every resolution.
Field<float> grain_height(const TileGrid& grid);

}  // namespace pentimento

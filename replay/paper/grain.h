#pragma once
// The grain of cold-pressed paper: smooth bumps of several sizes, in 0..1, a periodic function of
// the unit square. Reaches the state: own arithmetic only.

#include <span>

#include "replay/paper/weave.h"

namespace pentimento {

/// Value noise: cubic-smoothed random lattices of 12, 24, 48 ... points across one repeat, each
/// half as high as the one before; the first four make 0..1, finer ones are tooth on top of it. A
/// lattice finer than two cells fades out, so that the grain stays the same painting's at every
/// resolution and shows more where there are cells to show it. Writes the cells [x, x + out.size())
/// of row y.
void grain_row(const RepeatGrid& grid, int x, int y, std::span<float> out);

}  // namespace pentimento

#pragma once
// The grain of cold-pressed paper: smooth bumps of several sizes, in 0..1, as a periodic function
// of the unit square. It reaches the state, so it uses core's own arithmetic only.

#include <span>

#include "replay/paper/weave.h"

namespace pentimento {

/// Writes the grain in the cells [x, x + out.size()) of row y. It is value noise: random lattices
/// of 12, 24, 48 ... points across one repeat, smoothed by cubics, each half as high as the one
/// before. The first four make up 0..1; finer ones add tooth. A lattice finer than two cells fades
/// out. So the grain is the same at every resolution, and shows more where there are cells to show
/// it.
void grain_row(const RepeatGrid& grid, int x, int y, std::span<float> out);

}  // namespace pentimento

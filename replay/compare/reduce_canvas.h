#pragma once
// Planes of a canvas reduced by a whole factor, block by block, and never held whole before.

#include "core/base/field.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"

namespace pentimento {

/// Mean of each block of factor x factor cells; the grid is a whole multiple of `factor`. Sums are
/// in double, row by row: no rounding worth naming up to factor 32.
Field<float> block_means(const CanvasSource& canvas, PlaneId plane, int factor,
                         const Threads& threads);

}  // namespace pentimento

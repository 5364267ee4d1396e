#pragma once
// Reduces planes of a canvas by a whole factor, block by block, without ever holding a whole plane.

#include "core/base/field.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_source.h"

namespace pentimento {

/// The mean of each block of factor x factor cells. The sides of the grid must be multiples of
/// `factor`. Sums are in double, row by row, so rounding does not matter up to factor 32.
Field<float> block_means(const CanvasSource& canvas, PlaneId plane, int factor,
                         const Threads& threads);

}  // namespace pentimento

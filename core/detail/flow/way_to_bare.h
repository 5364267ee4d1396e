#pragma once
// How far each cell of a film lies from bare canvas.

#include "core/base/field.h"

namespace pentimento {

/// Way to the nearest bare cell, in thirds of a cell; 0 for bare cells, which are no deeper than
/// `bare_m`; far ones count as `far` >= 0.
/// Scheme: chamfer distance 3-4, down the rows and up again; each row is lowered by the row beside
/// it by vectors, then along itself. Exact in integers.
/// Source: Borgefors, Computer Vision, Graphics, and Image Processing 34 (1986) 344-371.
/// Departs from it: ways end at `far`.
Field<int> way_to_bare(const Field<float>& depth_m, float bare_m, int far);

}  // namespace pentimento

#pragma once
// The guide's surface as a smooth one over fine cells.

#include "core/base/field.h"
#include "core/canvas/canvas_state.h"
#include "core/canvas/cell_box.h"

namespace pentimento {

/// Height (m) of the guide's surface, base and wet paint, at the fine cells of `box`: the cubic
/// B-spline whose coefficients v have means over the guide's cells near the guide's heights h:
///   v = h; twice v <- v + h - M v;  M: mean over a cell of the spline, (1, 76, 230, 76, 1) / 384
///   along each axis
/// Scheme: Van Cittert's deconvolution (1931), cut short. Stable: M's symbol lies in (0, 1].
/// Source: Unser, IEEE Signal Processing Mag. 16 (1999) 22-38. Depends on h within 6 cells.
Field<float> surface_spline(const CanvasState& guide, const CellBox& box, int factor);

}  // namespace pentimento

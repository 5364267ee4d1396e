#pragma once
// Runny paint levels on the detail canvas, and its edge draws itself smooth: what the guide's
// height equation does at its own scale, and what lies below that scale.

#include "core/detail/changed_blocks.h"
#include "core/detail/detail_canvas.h"
#include "core/fluid/scheme.h"

namespace pentimento {

/// Relaxes the depth in the cells of tiles in `moving` where the guide's paint moves:
///   d' = d + L (t - d),  L = r dt / (1 + r dt),  r = |g| (1 - Phi) d_g^3 / (3 nu) q^2
///   t = m(W) max(0, S + b_s - b),  S = smooth d_g / W,  W = smooth f,
///   f = d_g / the largest d_g around where a cell around is bare, else 1; m rises from 0 at
///   W = 0.35 to 1 at W = 0.75
/// d_g and b_g: the guide's; smooth: smooth_field.h (of L too); b: of the fine cell; nu with the
/// floor of the friction; q^2 = 4e7 1/m^2, the ripples of a millimetre. What is added carries the
/// guide's pigment per depth, smoothed; what leaves takes along what the cell holds. Each pigment
/// relaxes in the same way towards an edge of its own, within a cell of it.
/// The contour of W lies where a front of full depth would, if it held what the guide's last cells
/// hold: so a glaze running at an angle has a smooth edge although the guide's is a staircase.
/// Scheme: implicit in the depth, explicit in t. Stable: 0 <= L < 1. Sums: restored by the lock.
/// Source: rate of a thin film, Reynolds 1886; docs/fidelity.md. Departs from it: |g| in place of
/// g_z, because a film on an upright canvas levels too (by surface tension).
void level_detail(DetailCanvas& canvas, const CanvasState& guide, const PaintEdges& edges,
                  const StepInput& in, const ChangedBlocks& moving);

}  // namespace pentimento

#pragma once
// Runny paint levels on the detail canvas, and its edge becomes smooth. The guide's height equation
// does that at the guide's scale; this file does it below that scale.

#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"
#include "core/fluid/scheme.h"

namespace pentimento {

/// Levelling changes cells of the guide no further than this from cells whose paint moves.
inline constexpr int kLevellingRadius = 3;

/// Relaxes the depth in the cells of tiles in `moving` where the guide's paint moves, or moves in a
/// cell beside it:
///   d' = d + L (t - d),  L = r dt / (1 + r dt),  r = |g| (1 - Phi) d_g^3 / (3 nu) q^2
///   t = m(W) max(0, S + b_s - b),  S = spline of c / W,  W = spline of f,
///   m rises from 0 at W = 0.35 to 1 at W = 0.85; c, f: film_spline.h
/// d_g and b_g: the guide's; b_s: smooth b_g (smooth_field.h; L too); b: of the fine cell; nu with
/// the floor of the friction; q^2 = 4e7 1/m^2, the ripples of a millimetre; L below 0.001 counts as
/// 0. What is added carries the guide's pigment per depth, smoothed; what leaves takes along what
/// the cell holds. Each pigment relaxes in the same way towards an edge of its own, within a cell
/// of it, where m rises from W = 0.35 to 0.75: paint lies on both sides of it. W comes as far as
/// the guide's last cells have paint: so a glaze running at an angle has a smooth edge although the
/// guide's is a staircase. The film ends at an angle, as a wetting edge does, not with a wall.
/// Scheme: implicit in the depth, explicit in t. Stable: 0 <= L < 1. Sums: restored by the lock.
/// Source: rate of a thin film, Reynolds 1886; docs/fidelity.md. Departs from it: |g| in place of
/// g_z, because a film on an upright canvas levels too (by surface tension).
void level_detail(DetailCanvas& canvas, const CanvasState& guide, const PaintEdges& edges,
                  const StepInput& in, const ChangedBlocks& moving);

}  // namespace pentimento

#pragma once
// Moves the fluid around velocity nodes, with its momentum, along one axis.

#include "core/fluid/conservative/advection/remap_row.h"

namespace pentimento::conservative {

/// Moves mass (scratch.value) and velocity (scratch.momentum, m/s) of a batch of nodes. Leaves
/// there the moved mass and the new velocity, momentum / mass, which is 0 where there is no mass.
/// The ends are walls.
///   m' = sum of parts of m; u' = (sum of parts of m, times their u) / m'
/// Scheme: piecewise linear in m and u, 2nd order where smooth.
/// Stable: any displacement; u' stays within the velocities of the parts.
/// Source: Lauritzen et al. 2010 (remap_plan.h); momentum on the staggered cell.
/// Departs from it: the part that stays has the momentum that is left, so that sums are kept.
void remap_momentum_batch(const RemapPlan& plan, const RemapOptions& options,
                          RemapScratch& scratch);

/// Paint around a node that carries no momentum worth keeping, in metres.
inline constexpr float kLeastNodeMass_m = 1e-9f;

/// The last step of the above, on a row: turns momentum into velocity, and empties nodes with next
/// to no paint.
void velocity_row(float* mass, float* momentum, int cells);

}  // namespace pentimento::conservative

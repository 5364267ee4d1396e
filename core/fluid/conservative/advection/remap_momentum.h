#pragma once
// Moves the fluid of velocity nodes with its momentum along one axis.

#include "core/fluid/conservative/advection/remap_row.h"

namespace pentimento::conservative {

/// Moves mass (scratch.value) and velocity (scratch.momentum, m/s) of a batch of nodes; leaves the
/// moved mass and the velocity momentum / mass there, 0 where no mass is. Ends are walls.
///   m' = sum of parts of m; u' = (sum of parts of m, times their u) / m'
/// Scheme: piecewise linear in m and u, 2nd order where smooth.
/// Stable: any displacement; u' stays within the velocities of the parts.
/// Source: Lauritzen et al. 2010 (remap_plan.h); momentum on the staggered cell.
/// Departs from it: the part that stays has the momentum that is left, so that sums are kept.
void remap_momentum_batch(const RemapPlan& plan, const RemapOptions& options,
                          RemapScratch& scratch);

/// The last step of it, on a row: momentum becomes velocity, and nodes with next to no paint are
/// emptied.
void velocity_row(float* mass, float* momentum, int cells);

}  // namespace pentimento::conservative

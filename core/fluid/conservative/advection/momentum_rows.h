#pragma once
// The kernels that move the fluid around velocity nodes, with its momentum, row by row.
//   m' = sum of parts of m; u' = (sum of parts of m, times their u) / m'
// Scheme: that of remap_plan.h and remap_rows.h, without rounding; piecewise linear in m and u, 2nd
//   order where smooth.
// Stable: any displacement; u' stays within the velocities of the parts.
// Source: Lauritzen et al. 2010 (remap_plan.h); momentum on the staggered cell.
// Departs from it: the part that stays has the momentum that is left, so that sums are kept.

#include "core/fluid/conservative/advection/remap_rows.h"

namespace pentimento::conservative {

/// What leaves a row of nodes over its low and its high edges, to be filled.
struct LeavingRow {
  float* mass_lo;
  float* mass_hi;
  float* momentum_lo;
  float* momentum_hi;
  float* stay;  // 1, or 0 for far nodes (remap_plan.h)
};

/// Finds what n nodes pass over their two edges, which move by edge.lo and edge.hi cells. Returns
/// how many of them are far nodes, which pass nothing.
int leave_momentum_rows(bool superbee, const LoHi& edge, const ThreeRows& mass,
                        const ThreeRows& velocity, int n, const LeavingRow& out);

/// Nodes before they moved.
struct NodesBefore {
  const float* mass;
  const float* velocity;
};
/// Nodes after they moved. They may lie where they lay before.
struct NodesAfter {
  float* mass;
  float* velocity;
};

/// Finds what n nodes become: mass, and momentum / mass.
void settle_velocity_rows(const float* stay, const Parts& mass, const Parts& momentum,
                          const NodesBefore& before, int n, const NodesAfter& after);
/// The same, but leaves momentum in the place of the velocity: for rows that far nodes are still
/// added to.
void settle_momentum_rows(const float* stay, const Parts& mass, const Parts& momentum,
                          const NodesBefore& before, int n, const NodesAfter& after);
/// The same for nodes that pass nothing, and get nothing, beside far ones.
void settle_resting_rows(const NodesBefore& before, bool divide, int n, const NodesAfter& after);

/// Paint around a node that carries no momentum worth keeping, in metres.
inline constexpr float kLeastNodeMass_m = 1e-9f;
/// Turns momentum into velocity, and empties nodes with next to no paint.
void velocity_row(float* mass, float* momentum, int n);

}  // namespace pentimento::conservative

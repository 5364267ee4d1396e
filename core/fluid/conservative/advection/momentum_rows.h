#pragma once
// The kernels that move the fluid around velocity nodes, with its momentum, row by row. Each does
// in one pass what remap_momentum_batch() does in several, one after the other: equations, scheme
// and sources are there (remap_momentum.h, remap_plan.h, remap_row.h), and the bits are the same.

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

}  // namespace pentimento::conservative

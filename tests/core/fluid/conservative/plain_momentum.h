#pragma once
// The plain twin of moving momentum: batch after batch, copied into flat arrays, moved there by
// remap_momentum_batch and copied back. Any axis.

#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/momentum_edges.h"
#include "tests/core/fluid/conservative/plain_batches.h"
#include "tests/core/fluid/conservative/plain_remap.h"

namespace pentimento::conservative {

// Moves the nodes of one component in one batch.
inline void move_momentum_batch(const LineBatch& b, const MomentumEdges& edges, bool along,
                                const RemapOptions& options, Turn turn,
                                const Field<float>& state_m_s, NodePlanes& nodes) {
  RemapPlan plan;
  RemapScratch scratch;
  plan.resize(b.cells(), b.step());
  scratch.resize(b.cells(), b.step());
  plan.before = b.axis == Axis::kX ? b.box.x0 : b.box.y0;
  edges.fill(b, along, plan.edge.data());
  plan_remap(plan);
  float* mass = scratch.cells(scratch.value, plan.step);
  float* velocity = scratch.cells(scratch.momentum, plan.step);
  if (turn == Turn::kFirst) {
    load_batch(b, nodes.first_mass_m, mass);
    load_batch(b, state_m_s, velocity);
  } else {
    load_batch(b, nodes.mass_m, mass);
    load_batch(b, nodes.velocity_m_s, velocity);
  }
  remap_momentum_batch(plan, options, scratch);
  store_batch(b, mass, nodes.mass_m);
  store_batch(b, velocity, nodes.velocity_m_s);
}

inline void advect_momentum_in_batches(const CanvasState& state, const StepInput& in, Axis axis,
                                       Turn turn, const WetCells& wet, Workspace& work) {
  const RemapOptions options{in.model.superbee, 0};
  const MomentumEdges edges(state, in.dt_s, axis,
                            axis == Axis::kX ? work.x.first_mass_m : work.y.first_mass_m);
  for_batches(wet, axis, in.threads, [&](int begin, int end, const auto& block_at) {
    for (int k = begin; k < end; ++k) {
      const LineBatch b = block_at(k);
      move_momentum_batch(b, edges, axis == Axis::kX, options, turn, state.velocity_x_m_s, work.x);
      move_momentum_batch(b, edges, axis == Axis::kY, options, turn, state.velocity_y_m_s, work.y);
    }
  });
}

}  // namespace pentimento::conservative

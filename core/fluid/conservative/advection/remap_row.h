#pragma once
// Remaps one quantity of a batch along one axis, by a plan (remap_plan.h).

#include <vector>

#include "core/fluid/conservative/advection/remap_plan.h"

namespace pentimento::conservative {

struct RemapOptions {
  bool superbee = false;
  float rounder = 0;  // quantum.h; 0 = no rounding of the moved parts
};

/// Buffers of one batch, reused from one quantity to the next.
struct RemapScratch {
  std::vector<float> value;     // step ghosts, n cells, step ghosts
  std::vector<float> out_lo;    // the same size: what leaves over the low edge
  std::vector<float> out_hi;    // the same size: what leaves over the high edge
  std::vector<float> momentum;  // as `value`; for remap_momentum
  std::vector<float> momentum_lo, momentum_hi;

  void resize(int cells, int step);
  float* cells(std::vector<float>& plane, int step) { return plane.data() + step; }
};

/// Fills the ghosts with copies of the end cells: no slope across the ends.
void mirror_ends(float* value, int cells, int step);

/// Moves the cells of a batch. Reads scratch.value and leaves the result there. The ends are walls.
/// If the values are multiples of the quantum and below 2^24 quanta, sums are exact and nothing
/// becomes negative.
void remap_batch(const RemapPlan& plan, const RemapOptions& options, RemapScratch& scratch);

/// Finds what each cell passes to its two neighbours.
///   out_hi = tau_hi (m + s/2 (1 - tau_hi)), out_lo = tau_lo (m - s/2 (1 - tau_lo)), rounded to
///   quanta and never more than there is; s: limited difference of the neighbours
/// Scheme: piecewise linear, 2nd order where smooth; monotone.
/// Stable: any displacement the plan allows.
/// Source: Lauritzen et al. 2010 (remap_plan.h), profiles of van Leer 1977 (limiter.h).
/// Departs from it: moved parts are whole quanta, so that sums are exact.
/// `value` has `step` more cells before and after. Far cells (stay = 0) pass nothing.
void remap_flux_row(const RemapPlan& plan, const RemapOptions& options, const float* value,
                    float* out_lo, float* out_hi);

/// value = stay value - out_lo - out_hi + what the two neighbours pass. Exact for whole quanta.
void remap_gather_row(const RemapPlan& plan, const float* out_lo, const float* out_hi,
                      float* value);

}  // namespace pentimento::conservative

#pragma once
// The plain twin of the remap (remap_rows.h, momentum_rows.h): a batch is a flat array of n cells
// whose neighbours along the axis of motion lie `step` apart: 1 for a row that moves along x, the
// width of the strip for columns that move along y. One thing after the other, in plain loops.

#include <algorithm>
#include <vector>

#include "core/fluid/conservative/advection/limiter.h"
#include "core/fluid/conservative/advection/momentum_rows.h"
#include "core/fluid/conservative/advection/remap_far.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {

/// The shares of a batch's cells that move. The share tau_lo of a cell goes over its low edge,
/// tau_hi over its high edge; both are shares of its length, in [0,1]. `stay` is 1, but 0 for far
/// cells: cells whose parts reach further than the next cell, or whose edges change order.
/// put_far_cells() moves far cells as a whole.
struct RemapPlan {
  int step = 1;
  int before = 0;           // cells of the grid before the batch, along the axis of motion
  std::vector<float> edge;  // n + step displacements in cells; cell i has edges i and i + step
  std::vector<float> tau_lo, tau_hi, stay;  // n
  std::vector<int> far;                     // cells with stay = 0, ascending

  void resize(int cells, int step_cells);
  int cells() const { return static_cast<int>(stay.size()); }
};

inline void RemapPlan::resize(int cells, int step_cells) {
  const auto n = static_cast<std::size_t>(cells);
  step = step_cells;
  edge.resize(n + static_cast<std::size_t>(step));
  tau_lo.resize(n);
  tau_hi.resize(n);
  stay.resize(n);
}

// Fills all of a plan but `edge`, from `edge`.
inline void plan_remap(RemapPlan& plan) {
  plan_remap_row(plan.edge.data(), plan.edge.data() + plan.step, plan.cells(), plan.tau_lo.data(),
                 plan.tau_hi.data(), plan.stay.data());
  plan.far.clear();
  if (count_far_row(plan.stay.data(), plan.cells()) == 0) return;
  for (int i = 0; i < plan.cells(); ++i)
    if (plan.stay[static_cast<std::size_t>(i)] == 0) plan.far.push_back(i);
}

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

template <float (*limited)(float, float)>
inline void flux_row(const RemapPlan& plan, float rounder, const float* __restrict value,
                     float* __restrict out_lo, float* __restrict out_hi) {
  const int n = plan.cells();
  const int step = plan.step;
  const float* __restrict tau_lo = plan.tau_lo.data();
  const float* __restrict tau_hi = plan.tau_hi.data();
  for (int i = 0; i < n; ++i) {
    const float m = value[i];
    const float half_slope = 0.5f * limited(m - value[i - step], value[i + step] - m);
    const float hi = rounded(tau_hi[i] * (m + half_slope * (1 - tau_hi[i])), rounder);
    const float kept_hi = hi < m ? hi : m;
    const float lo = rounded(tau_lo[i] * (m - half_slope * (1 - tau_lo[i])), rounder);
    const float left = m - kept_hi;
    out_hi[i] = kept_hi;
    out_lo[i] = lo < left ? lo : left;
  }
}

inline void flux_row_mc(const RemapPlan& plan, float rounder, const float* value, float* out_lo,
                        float* out_hi) {
  flux_row<limited_mc>(plan, rounder, value, out_lo, out_hi);
}

inline void flux_row_superbee(const RemapPlan& plan, float rounder, const float* value,
                              float* out_lo, float* out_hi) {
  flux_row<limited_superbee>(plan, rounder, value, out_lo, out_hi);
}

inline std::vector<FarCell> take_far_cells(const RemapPlan& plan, const RemapOptions& options,
                                           const float* value) {
  std::vector<FarCell> far;
  for (const int i : plan.far) {
    if (value[i] == 0) continue;
    const float slope = far_slope(options, {value - plan.step, value, value + plan.step}, i);
    const auto cell = static_cast<std::size_t>(i);
    const auto next = static_cast<std::size_t>(i + plan.step);
    far.push_back(
        {i / plan.step, i % plan.step, plan.edge[cell], plan.edge[next], value[i], slope});
  }
  return far;
}

inline void mirror_batch(float* value, int cells, int step) {
  std::copy_n(value, step, value - step);
  std::copy_n(value + cells - step, step, value + cells);
}

inline void RemapScratch::resize(int cells, int step) {
  const auto n = static_cast<std::size_t>(cells + 2 * step);
  for (std::vector<float>* v : {&value, &momentum}) v->resize(n);
  for (std::vector<float>* v : {&out_lo, &out_hi, &momentum_lo, &momentum_hi}) v->assign(n, 0);
}

inline void remap_flux_row(const RemapPlan& plan, const RemapOptions& options, const float* value,
                           float* out_lo, float* out_hi) {
  if (options.superbee)
    flux_row_superbee(plan, options.rounder, value, out_lo, out_hi);
  else
    flux_row_mc(plan, options.rounder, value, out_lo, out_hi);
}

inline void remap_gather_row(const RemapPlan& plan, const float* __restrict out_lo,
                             const float* __restrict out_hi, float* __restrict value) {
  const int n = plan.cells();
  const int step = plan.step;
  const float* __restrict stay = plan.stay.data();
  for (int i = 0; i < n; ++i) {
    const float kept = value[i] * stay[i] - out_hi[i] - out_lo[i];
    value[i] = kept + (out_hi[i - step] + out_lo[i + step]);
  }
}

inline void remap_batch(const RemapPlan& plan, const RemapOptions& options, RemapScratch& scratch) {
  const int step = plan.step;
  float* value = scratch.cells(scratch.value, step);
  float* lo = scratch.cells(scratch.out_lo, step);
  float* hi = scratch.cells(scratch.out_hi, step);
  mirror_batch(value, plan.cells(), step);
  remap_flux_row(plan, options, value, lo, hi);
  const std::vector<FarCell> far = take_far_cells(plan, options, value);
  remap_gather_row(plan, lo, hi, value);
  if (far.empty()) return;
  put_far_cells(far, {plan.cells() / step, plan.before}, options.rounder,
                [&](int at, int lane) -> float& { return value[at * step + lane]; });
}

// The parts' momentum: each part of length tau has the velocity at its own middle.
inline void momentum_flux_row(const RemapPlan& plan, const float* __restrict velocity,
                              const float* __restrict out_lo, const float* __restrict out_hi,
                              float* __restrict momentum_lo, float* __restrict momentum_hi) {
  const int n = plan.cells();
  const int step = plan.step;
  const float* __restrict tau_lo = plan.tau_lo.data();
  const float* __restrict tau_hi = plan.tau_hi.data();
  for (int i = 0; i < n; ++i) {
    const float u = velocity[i];
    const float half_slope = 0.5f * limited_mc(u - velocity[i - step], velocity[i + step] - u);
    momentum_hi[i] = out_hi[i] * (u + half_slope * (1 - tau_hi[i]));
    momentum_lo[i] = out_lo[i] * (u - half_slope * (1 - tau_lo[i]));
  }
}

inline void times_row(const float* __restrict mass, float* __restrict velocity, int cells) {
  for (int i = 0; i < cells; ++i) velocity[i] *= mass[i];
}

inline void remap_momentum_batch(const RemapPlan& plan, const RemapOptions& options,
                                 RemapScratch& scratch) {
  const int step = plan.step;
  const int n = plan.cells();
  float* mass = scratch.cells(scratch.value, step);
  float* velocity = scratch.cells(scratch.momentum, step);
  float* lo = scratch.cells(scratch.out_lo, step);
  float* hi = scratch.cells(scratch.out_hi, step);
  float* momentum_lo = scratch.cells(scratch.momentum_lo, step);
  float* momentum_hi = scratch.cells(scratch.momentum_hi, step);
  mirror_batch(mass, n, step);
  mirror_batch(velocity, n, step);
  RemapOptions unrounded = options;
  unrounded.rounder = 0;
  remap_flux_row(plan, unrounded, mass, lo, hi);
  momentum_flux_row(plan, velocity, lo, hi, momentum_lo, momentum_hi);

  const std::vector<FarCell> far = take_far_cells(plan, unrounded, mass);
  std::vector<float> speed;
  for (const FarCell& cell : far) speed.push_back(velocity[cell.at * step + cell.lane]);
  times_row(mass, velocity, n);
  remap_gather_row(plan, lo, hi, mass);
  remap_gather_row(plan, momentum_lo, momentum_hi, velocity);
  const auto at_cell = [&](float* plane) {
    return [plane, step](int at, int lane) -> float& { return plane[at * step + lane]; };
  };
  if (!far.empty())
    put_far_momentum(far, speed, {n / step, plan.before}, at_cell(mass), at_cell(velocity));
  velocity_row(mass, velocity, n);
}

}  // namespace pentimento::conservative

#include "core/fluid/conservative/advection/remap_momentum.h"

#include <algorithm>

#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/limiter.h"
#include "core/fluid/conservative/advection/remap_far.h"

namespace pentimento::conservative {
namespace {

// The parts' momentum: each part of length tau has the velocity at its own middle.
PENTIMENTO_KERNEL
void momentum_flux_row(const RemapPlan& plan, const float* __restrict velocity,
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

PENTIMENTO_KERNEL
void times_row(const float* __restrict mass, float* __restrict velocity, int cells) {
  for (int i = 0; i < cells; ++i) velocity[i] *= mass[i];
}

}  // namespace

PENTIMENTO_KERNEL
void velocity_row(float* __restrict mass, float* __restrict momentum, int cells) {
  for (int i = 0; i < cells; ++i) {
    const bool some = mass[i] > kLeastNodeMass_m;
    momentum[i] = some ? momentum[i] / (some ? mass[i] : 1.0f) : 0.0f;
    mass[i] = some ? mass[i] : 0.0f;
  }
}

void remap_momentum_batch(const RemapPlan& plan, const RemapOptions& options,
                          RemapScratch& scratch) {
  const int step = plan.step;
  const int n = plan.cells();
  float* mass = scratch.cells(scratch.value, step);
  float* velocity = scratch.cells(scratch.momentum, step);
  float* lo = scratch.cells(scratch.out_lo, step);
  float* hi = scratch.cells(scratch.out_hi, step);
  float* momentum_lo = scratch.cells(scratch.momentum_lo, step);
  float* momentum_hi = scratch.cells(scratch.momentum_hi, step);
  mirror_ends(mass, n, step);
  mirror_ends(velocity, n, step);
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

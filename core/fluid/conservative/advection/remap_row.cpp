#include "core/fluid/conservative/advection/remap_row.h"

#include <algorithm>

#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/limiter.h"
#include "core/fluid/conservative/advection/remap_far.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

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

PENTIMENTO_KERNEL
void flux_row_mc(const RemapPlan& plan, float rounder, const float* value, float* out_lo,
                 float* out_hi) {
  flux_row<limited_mc>(plan, rounder, value, out_lo, out_hi);
}

PENTIMENTO_KERNEL
void flux_row_superbee(const RemapPlan& plan, float rounder, const float* value, float* out_lo,
                       float* out_hi) {
  flux_row<limited_superbee>(plan, rounder, value, out_lo, out_hi);
}

}  // namespace

void mirror_ends(float* value, int cells, int step) {
  std::copy_n(value, step, value - step);
  std::copy_n(value + cells - step, step, value + cells);
}

void RemapScratch::resize(int cells, int step) {
  const auto n = static_cast<std::size_t>(cells + 2 * step);
  for (std::vector<float>* v : {&value, &momentum}) v->resize(n);
  for (std::vector<float>* v : {&out_lo, &out_hi, &momentum_lo, &momentum_hi}) v->assign(n, 0);
}

void remap_flux_row(const RemapPlan& plan, const RemapOptions& options, const float* value,
                    float* out_lo, float* out_hi) {
  if (options.superbee)
    flux_row_superbee(plan, options.rounder, value, out_lo, out_hi);
  else
    flux_row_mc(plan, options.rounder, value, out_lo, out_hi);
}

PENTIMENTO_KERNEL
void remap_gather_row(const RemapPlan& plan, const float* __restrict out_lo,
                      const float* __restrict out_hi, float* __restrict value) {
  const int n = plan.cells();
  const int step = plan.step;
  const float* __restrict stay = plan.stay.data();
  for (int i = 0; i < n; ++i) {
    const float kept = value[i] * stay[i] - out_hi[i] - out_lo[i];
    value[i] = kept + (out_hi[i - step] + out_lo[i + step]);
  }
}

void remap_batch(const RemapPlan& plan, const RemapOptions& options, RemapScratch& scratch) {
  const int step = plan.step;
  float* value = scratch.cells(scratch.value, step);
  float* lo = scratch.cells(scratch.out_lo, step);
  float* hi = scratch.cells(scratch.out_hi, step);
  mirror_ends(value, plan.cells(), step);
  remap_flux_row(plan, options, value, lo, hi);
  const std::vector<FarCell> far = take_far_cells(plan, options, value);
  remap_gather_row(plan, lo, hi, value);
  if (far.empty()) return;
  put_far_cells(far, {plan.cells() / step, plan.before}, options.rounder,
                [&](int at, int lane) -> float& { return value[at * step + lane]; });
}

}  // namespace pentimento::conservative

#include "core/fluid/conservative/advection/remap_rows.h"

#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/limiter.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

template <float (*half_limited)(float, float)>
inline void flux_cells(const LoHi& tau, float rounder, const ThreeRows& value, int n,
                       float* __restrict out_lo, float* __restrict out_hi) {
  const float* __restrict tau_lo = tau.lo;
  const float* __restrict tau_hi = tau.hi;
  const float* before = value.before;
  const float* here = value.here;
  const float* after = value.after;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float m = here[i];
    const float half_slope = half_limited(m - before[i], after[i] - m);
    const float hi = rounded(tau_hi[i] * (m + half_slope * (1 - tau_hi[i])), rounder);
    const float kept_hi = hi < m ? hi : m;
    const float lo = rounded(tau_lo[i] * (m - half_slope * (1 - tau_lo[i])), rounder);
    const float left = m - kept_hi;
    out_hi[i] = kept_hi;
    out_lo[i] = lo < left ? lo : left;
  }
}

PENTIMENTO_KERNEL
void flux_rows_mc(const LoHi& tau, float rounder, const ThreeRows& value, int n, float* out_lo,
                  float* out_hi) {
  flux_cells<half_limited_mc>(tau, rounder, value, n, out_lo, out_hi);
}

PENTIMENTO_KERNEL
void flux_rows_superbee(const LoHi& tau, float rounder, const ThreeRows& value, int n,
                        float* out_lo, float* out_hi) {
  flux_cells<half_limited_superbee>(tau, rounder, value, n, out_lo, out_hi);
}

}  // namespace

void flux_rows(const RemapOptions& options, const LoHi& tau, const ThreeRows& value, int n,
               float* out_lo, float* out_hi) {
  const auto flux = options.superbee ? flux_rows_superbee : flux_rows_mc;
  flux(tau, options.rounder, value, n, out_lo, out_hi);
}

PENTIMENTO_KERNEL
void gather_rows(const float* __restrict stay, const Parts& parts, int n, float* __restrict value) {
  const float* __restrict hi_before = parts.hi_before;
  const float* __restrict hi = parts.hi;
  const float* __restrict lo = parts.lo;
  const float* __restrict lo_after = parts.lo_after;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float kept = value[i] * stay[i] - hi[i] - lo[i];
    value[i] = kept + (hi_before[i] + lo_after[i]);
  }
}

PENTIMENTO_KERNEL
void gather_beside_rows(const float* __restrict stay, const Parts& parts,
                        const float* __restrict moving, const float* __restrict held, int n,
                        float* __restrict value) {
  const float* __restrict hi_before = parts.hi_before;
  const float* __restrict hi = parts.hi;
  const float* __restrict lo = parts.lo;
  const float* __restrict lo_after = parts.lo_after;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float kept = moving[i] * stay[i] - hi[i] - lo[i];
    value[i] = kept + (hi_before[i] + lo_after[i]) + held[i];
  }
}

void mirror_ends(float* value, int n) {
  value[-1] = value[0];
  value[n] = value[n - 1];
}

}  // namespace pentimento::conservative

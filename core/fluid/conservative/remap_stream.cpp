#include "core/fluid/conservative/remap_stream.h"

#include "core/fluid/conservative/kernel.h"
#include "core/fluid/conservative/limiter.h"
#include "core/fluid/conservative/quantum.h"
#include "core/fluid/conservative/remap_momentum.h"

namespace pentimento::conservative {
namespace {

struct Taus {
  const float* lo;
  const float* hi;
};

// The kernels of remap_row.cpp and remap_momentum.cpp, with neighbours in rows of their own.
template <float (*limited)(float, float)>
inline void flux_rows(const Taus& tau, float rounder, const ThreeRows& value, int n,
                      float* __restrict out_lo, float* __restrict out_hi) {
  const float* __restrict tau_lo = tau.lo;
  const float* __restrict tau_hi = tau.hi;
  const float* before = value.before;
  const float* here = value.here;
  const float* after = value.after;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float m = here[i];
    const float half_slope = 0.5f * limited(m - before[i], after[i] - m);
    const float hi = rounded(tau_hi[i] * (m + half_slope * (1 - tau_hi[i])), rounder);
    const float kept_hi = hi < m ? hi : m;
    const float lo = rounded(tau_lo[i] * (m - half_slope * (1 - tau_lo[i])), rounder);
    const float left = m - kept_hi;
    out_hi[i] = kept_hi;
    out_lo[i] = lo < left ? lo : left;
  }
}

PENTIMENTO_KERNEL
void flux_rows_mc(const Taus& tau, float rounder, const ThreeRows& value, int n, float* out_lo,
                  float* out_hi) {
  flux_rows<limited_mc>(tau, rounder, value, n, out_lo, out_hi);
}

PENTIMENTO_KERNEL
void flux_rows_superbee(const Taus& tau, float rounder, const ThreeRows& value, int n,
                        float* out_lo, float* out_hi) {
  flux_rows<limited_superbee>(tau, rounder, value, n, out_lo, out_hi);
}

struct Parts {
  const float* hi_before;
  const float* hi;
  const float* lo;
  const float* lo_after;
};

PENTIMENTO_KERNEL
void gather_rows(const float* __restrict stay, const Parts& parts, int n,
                 float* __restrict value) {
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
void momentum_flux_rows(const Taus& tau, const ThreeRows& velocity, const Taus& mass_out, int n,
                        float* __restrict out_lo, float* __restrict out_hi) {
  const float* __restrict tau_lo = tau.lo;
  const float* __restrict tau_hi = tau.hi;
  const float* __restrict mass_lo = mass_out.lo;
  const float* __restrict mass_hi = mass_out.hi;
  const float* before = velocity.before;
  const float* here = velocity.here;
  const float* after = velocity.after;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float u = here[i];
    const float half_slope = 0.5f * limited_mc(u - before[i], after[i] - u);
    out_hi[i] = mass_hi[i] * (u + half_slope * (1 - tau_hi[i]));
    out_lo[i] = mass_lo[i] * (u - half_slope * (1 - tau_lo[i]));
  }
}

PENTIMENTO_KERNEL
void times_rows(const float* __restrict mass, int n, float* __restrict velocity) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) velocity[i] *= mass[i];
}

PENTIMENTO_KERNEL
int count_far(const float* __restrict stay, int n) {
  int far = 0;
  for (int i = 0; i < n; ++i) far += stay[i] == 0 ? 1 : 0;
  return far;
}

float slope_at(const RemapOptions& options, const ThreeRows& value, int i) {
  const float below = value.here[i] - value.before[i];
  const float above = value.after[i] - value.here[i];
  return options.superbee ? limited_superbee(below, above) : limited_mc(below, above);
}

}  // namespace

void EdgeStream::resize(int n) {
  n_ = n;
  tau_ = Field<float>(n, 2);
  ones_ = Field<float>(n, 1, 1.0f);
  stay_.resize(n);
}

void EdgeStream::plan(int r, const float* edge_lo, const float* edge_hi, bool moves) {
  moves_[static_cast<std::size_t>((r + 3) % 3)] = moves;
  far_.clear();
  if (!moves) return;
  edge_lo_ = edge_lo;
  edge_hi_ = edge_hi;
  float* stay = stay_.row(r);
  plan_remap_row(edge_lo, edge_hi, n_, tau_.row(0), tau_.row(1), stay);
  if (count_far(stay, n_) == 0) return;
  for (int i = 0; i < n_; ++i)
    if (stay[i] == 0) far_.push_back(i);
}

void QuantityStream::resize(int n) {
  n_ = n;
  out_lo_.resize(n);
  out_hi_.resize(n);
  zeros_ = Field<float>(n, 1);
}

void QuantityStream::begin() {
  passes_ = {};
  far_.clear();
}

void QuantityStream::flux(const EdgeStream& edges, const RemapOptions& options, int r,
                          const ThreeRows& value, bool some) {
  passes(r) = some && edges.moves(r);
  if (!passes(r)) return;
  const auto flux = options.superbee ? flux_rows_superbee : flux_rows_mc;
  flux({edges.tau_.row(0), edges.tau_.row(1)}, options.rounder, value, n_, out_lo_.row(r),
       out_hi_.row(r));
  for (const int i : edges.far_)
    if (value.here[i] != 0)
      far_.push_back({r, i, edges.edge_lo_[i], edges.edge_hi_[i], value.here[i],
                      slope_at(options, value, i)});
}

bool QuantityStream::gather(const EdgeStream& edges, int r, float* value) {
  if (!passes(r - 1) && !passes(r) && !passes(r + 1)) return false;
  gather_rows(edges.stay(r), {out_hi(r - 1), out_hi(r), out_lo(r), out_lo(r + 1)}, n_, value);
  return true;
}

void MomentumStream::resize(int n) {
  mass_.resize(n);
  out_lo_.resize(n);
  out_hi_.resize(n);
}

void MomentumStream::begin() {
  mass_.begin();
  far_speed_.clear();
}

void MomentumStream::flux(const EdgeStream& edges, const RemapOptions& options, int r,
                          const ThreeRows& mass, const ThreeRows& velocity) {
  const std::size_t known = mass_.far().size();
  mass_.flux(edges, options, r, mass, true);
  if (!edges.moves(r)) return;
  momentum_flux_rows({edges.tau_.row(0), edges.tau_.row(1)}, velocity,
                     {mass_.out_lo(r), mass_.out_hi(r)}, mass_.n_, out_lo_.row(r), out_hi_.row(r));
  for (std::size_t k = known; k < mass_.far().size(); ++k)
    far_speed_.push_back(velocity.here[mass_.far()[k].lane]);
}

void MomentumStream::gather(const EdgeStream& edges, int r, float* mass, float* velocity,
                            bool divide) {
  const auto lo = [&](int row) { return mass_.passes(row) ? out_lo_.row(row) : mass_.zeros_.row(0); };
  const auto hi = [&](int row) { return mass_.passes(row) ? out_hi_.row(row) : mass_.zeros_.row(0); };
  times_rows(mass, mass_.n_, velocity);
  if (mass_.gather(edges, r, mass))
    gather_rows(edges.stay(r), {hi(r - 1), hi(r), lo(r), lo(r + 1)}, mass_.n_, velocity);
  if (divide) velocity_row(mass, velocity, mass_.n_);
}

}  // namespace pentimento::conservative

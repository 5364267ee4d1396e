#include "core/fluid/conservative/advection/momentum_rows.h"

#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/limiter.h"
#include "core/fluid/conservative/advection/remap_plan.h"

namespace pentimento::conservative {
namespace {

template <float (*half_limited)(float, float)>
inline int leave_cells(const LoHi& edge, const ThreeRows& mass, const ThreeRows& velocity, int n,
                       const LeavingRow& out) {
  const float* __restrict edge_lo = edge.lo;
  const float* __restrict edge_hi = edge.hi;
  float* __restrict mass_lo = out.mass_lo;
  float* __restrict mass_hi = out.mass_hi;
  float* __restrict momentum_lo = out.momentum_lo;
  float* __restrict momentum_hi = out.momentum_hi;
  float* __restrict stay = out.stay;
  int far = 0;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    // Which shares of the node go over its edges.
    const RemapShares go = remap_shares(edge_lo[i], edge_hi[i]);
    // The mass in them, ...
    const float m = mass.here[i];
    const float half_slope = half_limited(m - mass.before[i], mass.after[i] - m);
    const float hi = go.hi * (m + half_slope * (1 - go.hi));
    const float kept_hi = hi < m ? hi : m;
    const float lo = go.lo * (m - half_slope * (1 - go.lo));
    const float left = m - kept_hi;
    const float kept_lo = lo < left ? lo : left;
    // ... and its momentum, with the velocity at the middle of each.
    const float u = velocity.here[i];
    const float half_u = half_limited_mc(u - velocity.before[i], velocity.after[i] - u);
    mass_hi[i] = kept_hi;
    mass_lo[i] = kept_lo;
    momentum_hi[i] = kept_hi * (u + half_u * (1 - go.hi));
    momentum_lo[i] = kept_lo * (u - half_u * (1 - go.lo));
    stay[i] = go.near;
    far += go.near == 0 ? 1 : 0;
  }
  return far;
}

PENTIMENTO_KERNEL
int leave_rows_mc(const LoHi& edge, const ThreeRows& mass, const ThreeRows& velocity, int n,
                  const LeavingRow& out) {
  return leave_cells<half_limited_mc>(edge, mass, velocity, n, out);
}

PENTIMENTO_KERNEL
int leave_rows_superbee(const LoHi& edge, const ThreeRows& mass, const ThreeRows& velocity, int n,
                        const LeavingRow& out) {
  return leave_cells<half_limited_superbee>(edge, mass, velocity, n, out);
}

template <bool divide>
inline void settle_cells(const float* __restrict stay, const Parts& mass, const Parts& momentum,
                         const NodesBefore& before, int n, const NodesAfter& after) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float was = before.mass[i];
    const float kept = was * stay[i] - mass.hi[i] - mass.lo[i];
    const float kept_momentum =
        before.velocity[i] * was * stay[i] - momentum.hi[i] - momentum.lo[i];
    const float m = kept + (mass.hi_before[i] + mass.lo_after[i]);
    const float p = kept_momentum + (momentum.hi_before[i] + momentum.lo_after[i]);
    const bool some = m > kLeastNodeMass_m;
    after.velocity[i] = !divide ? p : some ? p / (some ? m : 1.0f) : 0.0f;
    after.mass[i] = !divide || some ? m : 0.0f;
  }
}

PENTIMENTO_KERNEL
void momentum_row(const NodesBefore& before, int n, const NodesAfter& after) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    after.velocity[i] = before.velocity[i] * before.mass[i];
    after.mass[i] = before.mass[i];
  }
}

}  // namespace

int leave_momentum_rows(bool superbee, const LoHi& edge, const ThreeRows& mass,
                        const ThreeRows& velocity, int n, const LeavingRow& out) {
  const auto leave = superbee ? leave_rows_superbee : leave_rows_mc;
  return leave(edge, mass, velocity, n, out);
}

PENTIMENTO_KERNEL
void settle_velocity_rows(const float* stay, const Parts& mass, const Parts& momentum,
                          const NodesBefore& before, int n, const NodesAfter& after) {
  settle_cells<true>(stay, mass, momentum, before, n, after);
}

PENTIMENTO_KERNEL
void settle_momentum_rows(const float* stay, const Parts& mass, const Parts& momentum,
                          const NodesBefore& before, int n, const NodesAfter& after) {
  settle_cells<false>(stay, mass, momentum, before, n, after);
}

void settle_resting_rows(const NodesBefore& before, bool divide, int n, const NodesAfter& after) {
  momentum_row(before, n, after);
  if (divide) velocity_row(after.mass, after.velocity, n);
}

PENTIMENTO_KERNEL
void velocity_row(float* __restrict mass, float* __restrict momentum, int n) {
  for (int i = 0; i < n; ++i) {
    const bool some = mass[i] > kLeastNodeMass_m;
    momentum[i] = some ? momentum[i] / (some ? mass[i] : 1.0f) : 0.0f;
    mass[i] = some ? mass[i] : 0.0f;
  }
}

}  // namespace pentimento::conservative

#include "core/fluid/conservative/solve/force_row.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void force_row(const LateralGravity& g, const float* __restrict depth_m,
               const float* __restrict mobility_frac, const float* __restrict friction_frac, int n,
               float* __restrict velocity_m_s) {
  const float speed = g.speed_m_s;
  const float dry_film = g.dry_film_m;
  const bool scaled = g.scaled_by_mobility;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float whole = depth_m[i] > dry_film ? 1.0f : 0.0f;
    const float share = scaled ? mobility_frac[i] : whole;
    velocity_m_s[i] = friction_frac[i] * (velocity_m_s[i] - speed * share);
  }
}

}  // namespace pentimento::conservative

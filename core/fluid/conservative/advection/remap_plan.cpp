#include "core/fluid/conservative/advection/remap_plan.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void plan_remap_row(const float* __restrict edge_lo, const float* __restrict edge_hi, int cells,
                    float* __restrict tau_lo, float* __restrict tau_hi, float* __restrict stay) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < cells; ++i) {
    const RemapShares shares = remap_shares(edge_lo[i], edge_hi[i]);
    tau_lo[i] = shares.lo;
    tau_hi[i] = shares.hi;
    stay[i] = shares.near;
  }
}

PENTIMENTO_KERNEL
int count_far_row(const float* __restrict stay, int cells) {
  int far = 0;
  for (int i = 0; i < cells; ++i) far += stay[i] == 0 ? 1 : 0;
  return far;
}

}  // namespace pentimento::conservative

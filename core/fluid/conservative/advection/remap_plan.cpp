#include "core/fluid/conservative/advection/remap_plan.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {

void RemapPlan::resize(int cells, int step_cells) {
  const auto n = static_cast<std::size_t>(cells);
  step = step_cells;
  edge.resize(n + static_cast<std::size_t>(step));
  tau_lo.resize(n);
  tau_hi.resize(n);
  stay.resize(n);
}

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

void plan_remap(RemapPlan& plan) {
  plan_remap_row(plan.edge.data(), plan.edge.data() + plan.step, plan.cells(), plan.tau_lo.data(),
                 plan.tau_hi.data(), plan.stay.data());
  plan.far.clear();
  if (count_far_row(plan.stay.data(), plan.cells()) == 0) return;
  for (int i = 0; i < plan.cells(); ++i)
    if (plan.stay[static_cast<std::size_t>(i)] == 0) plan.far.push_back(i);
}

}  // namespace pentimento::conservative

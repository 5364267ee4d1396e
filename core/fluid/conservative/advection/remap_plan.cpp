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
  constexpr float kMinLength = 1.0f / 64;  // shorter images are moved as points
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < cells; ++i) {
    const float lo = edge_lo[i];
    const float hi = edge_hi[i];
    const float length = 1 + hi - lo;
    const float low = lo < 0 ? -lo : lo;
    const float high = hi < 0 ? -hi : hi;
    const bool near = (low <= 1) & (high <= 1) & (length >= kMinLength);
    const float inverse = 1 / (near ? length : 1.0f);
    const float over_lo = lo < 0 ? -lo * inverse : 0.0f;
    const float over_hi = hi > 0 ? hi * inverse : 0.0f;
    tau_lo[i] = near ? over_lo : 0.0f;
    tau_hi[i] = near ? over_hi : 0.0f;
    stay[i] = near ? 1.0f : 0.0f;
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

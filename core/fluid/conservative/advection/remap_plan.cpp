#include "core/fluid/conservative/advection/remap_plan.h"

#include <cmath>

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
    const float low = std::abs(lo);
    const float high = std::abs(hi);
    const float farther = low > high ? low : high;
    // Masks as numbers: of conditions that follow from one another the compiler makes branches.
    const float near = (length >= kMinLength ? 1.0f : 0.0f) * (farther <= 1 ? 1.0f : 0.0f);
    const float inverse = near / (length > kMinLength ? length : kMinLength);
    const float below = 0.5f * (low - lo);  // -lo where lo < 0, else 0, without rounding
    const float above = 0.5f * (high + hi);
    tau_lo[i] = (below < 1 ? below : 1.0f) * inverse;
    tau_hi[i] = (above < 1 ? above : 1.0f) * inverse;
    stay[i] = near;
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

#include "core/fluid/conservative/viscous_row.h"

#include "core/fluid/conservative/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void viscous_row(const ViscousNodes& nodes, float per_dx2, float per_dy2, int n,
                 const SystemRow& out) {
  const float* __restrict depth = nodes.depth;
  const float* __restrict above = nodes.depth_above;
  const float* __restrict below = nodes.depth_below;
  const float* __restrict nu = nodes.viscosity_m2_s;
  const float* __restrict nu_below = nodes.viscosity_below;
  float* __restrict cx = out.cx;
  float* __restrict cy = out.cy;
  float* __restrict z = out.zero_order;
  float* __restrict rhs = out.rhs;
  float* __restrict solution = out.solution;
  for (int i = 0; i < n; ++i) {
    const bool wet = depth[i] > 0;
    const float own_x = wet ? per_dx2 * nu[i] : 0.0f;
    const float own_y = wet ? per_dy2 * nu[i] : 0.0f;
    const float other_x = per_dx2 * nu[i + 1];
    const float other_y = per_dy2 * nu_below[i];
    cx[i] = depth[i + 1] > 0 && wet ? 0.5f * (own_x + other_x) : 0.0f;
    cy[i] = below[i] > 0 && wet ? 0.5f * (own_y + other_y) : 0.0f;
    const float held_x = (depth[i - 1] == 0 ? own_x : 0.0f) + (depth[i + 1] == 0 ? own_x : 0.0f);
    const float held_y = (above[i] == 0 ? own_y : 0.0f) + (below[i] == 0 ? own_y : 0.0f);
    z[i] = 1 + (held_x + held_y);
    const float u = wet ? nodes.velocity_m_s[i] : 0.0f;
    rhs[i] = u;
    solution[i] = u;
  }
}

}  // namespace pentimento::conservative

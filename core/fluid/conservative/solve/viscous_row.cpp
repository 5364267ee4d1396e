#include "core/fluid/conservative/solve/viscous_row.h"

#include "core/base/kernel.h"

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
  const float* __restrict velocity = nodes.velocity_m_s;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float left = depth[i - 1];
    const float right = depth[i + 1];
    const float up = above[i];
    const float down = below[i];
    const bool wet = depth[i] > 0;
    const float nu_wet = nu[i] * (wet ? 1.0f : 0.0f);
    const float own_x = per_dx2 * nu_wet;
    const float own_y = per_dy2 * nu_wet;
    const float joint_x = 0.5f * (own_x + per_dx2 * nu[i + 1]);
    const float joint_y = 0.5f * (own_y + per_dy2 * nu_below[i]);
    const float held_x = (left == 0 ? own_x : 0.0f) + (right == 0 ? own_x : 0.0f);
    const float held_y = (up == 0 ? own_y : 0.0f) + (down == 0 ? own_y : 0.0f);
    const float u = velocity[i] * (wet ? 1.0f : 0.0f);
    cx[i] = joint_x * ((wet & (right > 0)) ? 1.0f : 0.0f);
    cy[i] = joint_y * ((wet & (down > 0)) ? 1.0f : 0.0f);
    z[i] = (wet ? 1.0f : 0.0f) + (held_x + held_y);  // held_x and held_y are 0 where dry
    rhs[i] = u;
  }
}

}  // namespace pentimento::conservative

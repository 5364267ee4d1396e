#include "core/fluid/conservative/solve/height_row.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void height_rhs_row(const FluxRow& f, const float* __restrict height_m, float dt_per_dx,
                    float dt_per_dy, int n, float* __restrict rhs) {
  const float* __restrict dx = f.depth_x;
  const float* __restrict ux = f.velocity_x;
  const float* __restrict d_above = f.depth_above;
  const float* __restrict u_above = f.velocity_above;
  const float* __restrict d_below = f.depth_below;
  const float* __restrict u_below = f.velocity_below;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float out_x = dx[i] * ux[i] - dx[i - 1] * ux[i - 1];
    const float out_y = d_below[i] * u_below[i] - d_above[i] * u_above[i];
    rhs[i] = height_m[i] - (dt_per_dx * out_x + dt_per_dy * out_y);
  }
}

PENTIMENTO_KERNEL
void crowding_row(const Crowding& c, const float* __restrict depth_m,
                  const float* __restrict base_m, int n, float* __restrict crowding_m_s2) {
  const float from = c.from_m;
  const float most = c.most_m_s2;
  const float per_m = most / c.range_m;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float to_come = crowding_m_s2[i] - base_m[i];
    const float depth = depth_m[i] > to_come ? depth_m[i] : to_come;
    const float pressure = per_m * (depth - from);
    const float positive = pressure > 0 ? pressure : 0.0f;
    crowding_m_s2[i] = positive < most ? positive : most;
  }
}

PENTIMENTO_KERNEL
void pressure_row(const PressureRow& f, float dt_gravity_m_s, float dt_s, float dt_per_dx2, int n,
                  float* __restrict pressure_m_s, float* __restrict coupling) {
  const float* __restrict depth = f.depth_m;
  const float* __restrict mobility = f.mobility_frac;
  const float* __restrict friction = f.friction_frac;
  const float* __restrict crowding_a = f.crowding_a;
  const float* __restrict crowding_b = f.crowding_b;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float crowding = crowding_a[i] > crowding_b[i] ? crowding_a[i] : crowding_b[i];
    const float dt_gravity = dt_gravity_m_s + dt_s * pressure_m_s[i];
    const float k = friction[i] * (dt_gravity * mobility[i] + dt_s * crowding);
    pressure_m_s[i] = k;
    coupling[i] = k * depth[i] * dt_per_dx2;
  }
}

PENTIMENTO_KERNEL
void finish_row(float cap_m_s, const FinishRow& f, float per_dx, int n,
                float* __restrict velocity_m_s) {
  const float* __restrict depth_m = f.depth_m;
  const float* __restrict pressure_m_s = f.pressure_m_s;
  const float* __restrict height_a = f.height_a;
  const float* __restrict height_b = f.height_b;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float free = velocity_m_s[i] - pressure_m_s[i] * ((height_b[i] - height_a[i]) * per_dx);
    const float below = free < cap_m_s ? free : cap_m_s;
    const float u = below > -cap_m_s ? below : -cap_m_s;
    velocity_m_s[i] = depth_m[i] > 0 ? u : 0.0f;
  }
}

PENTIMENTO_KERNEL
void stand_row(float threshold_m_s, const NodesBeside& beside, const NodesAround& around, int n,
               float* __restrict out_m_s) {
  const float* here = beside.here_m_s;
  const float* before = beside.before_m_s;
  const float* after = beside.after_m_s;
  const auto [a0, a1, a2, a3] = around.one_side_m_s;
  const auto [b0, b1, b2, b3] = around.other_side_m_s;
  const float slowest2 = threshold_m_s * threshold_m_s;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float u = here[i];
    const float alone = 0.5f * u;
    const float mean = 0.25f * (before[i] + after[i]) + alone;
    const float near = (a1[i] + b1[i]) + (a2[i] + b2[i]);
    const float far = (a0[i] + b0[i]) + (a3[i] + b3[i]);
    const float v = 0.1875f * near + 0.0625f * far;
    const float alone2 = alone * alone;
    const float mean2 = mean * mean;
    const float along2 = alone2 > mean2 ? alone2 : mean2;
    out_m_s[i] = along2 + v * v >= slowest2 ? u : 0.0f;
  }
}

}  // namespace pentimento::conservative

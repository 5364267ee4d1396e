#include "core/fluid/conservative/advection/paint_rows.h"

#include <bit>
#include <cstdint>

#include "core/base/kernel.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void flow_row(const float* __restrict velocity_m_s, float dt_s, float per_m, int n,
              float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = velocity_m_s[i] * dt_s * per_m;
}

PENTIMENTO_KERNEL
void push_row(const float* here_m, const float* next_m, float per_m, int n, float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = 0.5f * (here_m[i] + next_m[i]) * per_m;
}

PENTIMENTO_KERNEL
void depth_edge_row(const float* __restrict flow, const float* __restrict push, int n,
                    float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = flow[i] + 0.5f * push[i];
}

PENTIMENTO_KERNEL
void flow_of_edge_row(const float* __restrict edge, const float* __restrict push, int n,
                      float* __restrict flow) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) flow[i] = edge[i] - 0.5f * push[i];
}

PENTIMENTO_KERNEL
bool weigh_row(const float* __restrict amount, float weight, int n, float* __restrict sum) {
  std::int32_t any = 0;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    any |= std::bit_cast<std::int32_t>(amount[i]);
    sum[i] += weight * amount[i];
  }
  return any != 0;
}

PENTIMENTO_KERNEL
int weigh_four_rows(const std::array<const float*, 4>& amount, const float* weights, int n,
                    float* __restrict sum) {
  const float* __restrict a = amount[0];
  const float* __restrict b = amount[1];
  const float* __restrict c = amount[2];
  const float* __restrict d = amount[3];
  const float weight_a = weights[0], weight_b = weights[1], weight_c = weights[2],
              weight_d = weights[3];
  std::int32_t any_a = 0, any_b = 0, any_c = 0, any_d = 0;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    any_a |= std::bit_cast<std::int32_t>(a[i]);
    any_b |= std::bit_cast<std::int32_t>(b[i]);
    any_c |= std::bit_cast<std::int32_t>(c[i]);
    any_d |= std::bit_cast<std::int32_t>(d[i]);
    sum[i] = (((sum[i] + weight_a * a[i]) + weight_b * b[i]) + weight_c * c[i]) + weight_d * d[i];
  }
  return (any_a != 0 ? 1 : 0) | (any_b != 0 ? 2 : 0) | (any_c != 0 ? 4 : 0) | (any_d != 0 ? 8 : 0);
}

PENTIMENTO_KERNEL
void free_row(float residue, int n, float* __restrict sum_to_free, float* __restrict share) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float s = sum_to_free[i];
    const bool more = s > residue;
    const float free = more ? s - residue : 0.0f;
    share[i] = free / (more ? s : 1.0f);
    sum_to_free[i] = free;
  }
}

PENTIMENTO_KERNEL
void add_row(const float* __restrict layer, int n, float* __restrict total) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) total[i] += layer[i];
}

PENTIMENTO_KERNEL
void split_residue_row(const float* value, const float* __restrict share, float rounder, int n,
                       float* __restrict held, float* free) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float v = value[i];
    const float wanted = rounded(v * share[i], rounder);
    const float moves = v < wanted ? v : wanted;
    held[i] = v - moves;
    free[i] = moves;
  }
}

PENTIMENTO_KERNEL
bool any_motion_row(const float* edge, int n) {
  std::int32_t any = 0;
  for (int i = 0; i < n; ++i) any |= std::bit_cast<std::int32_t>(edge[i]) & 0x7fffffff;
  return any != 0;
}

PENTIMENTO_KERNEL
bool any_beyond_row(const float* edge, float limit, int n) {
  int beyond = 0;
  for (int i = 0; i < n; ++i) beyond |= edge[i] > limit || edge[i] < -limit ? 1 : 0;
  return beyond != 0;
}

}  // namespace pentimento::conservative

#include "core/fluid/conservative/solve/capillary_row.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {
constexpr float kFades = 0.3f;  // of the deepest film that its surface carries: curvature_row

/// weight * the rise to the next cell, or, where the weight is negative, the drop to the edge of
/// the film: at most `most`, and none towards a cell that stands higher.
inline __attribute__((always_inline)) float weighted_rise(float weight, float rise, float most) {
  const float fall = rise < 0 ? -rise : 0.0f;
  const float drop = fall < most ? fall : most;
  return weight * (weight < 0 ? drop : rise);
}
}  // namespace

PENTIMENTO_KERNEL
void film_weight_row(const float* __restrict depth_a, const float* __restrict depth_b,
                     float least_film_m, float per_d2, int n, float* __restrict weight) {
  const float least = least_film_m;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float shallow = depth_a[i] < depth_b[i] ? depth_a[i] : depth_b[i];
    const float deep = depth_a[i] < depth_b[i] ? depth_b[i] : depth_a[i];
    const float edge = deep > least ? -2 * per_d2 : 0.0f;
    weight[i] = shallow > least ? per_d2 : edge;
  }
}

PENTIMENTO_KERNEL
void curvature_row(const SurfaceRow& s, const EdgeDrop& most, float tension_m3_s2, int n,
                   float* __restrict head_m2_s2) {
  const float* __restrict above = s.above_m;
  const float* __restrict here = s.here_m;
  const float* __restrict below = s.below_m;
  const float* __restrict base = s.base_m;
  const float* __restrict wx = s.weight_x;
  const float* __restrict wa = s.weight_above;
  const float* __restrict wb = s.weight_below;
  const float most_x = most.x_m, most_y = most.y_m, per_fade = 1 / (kFades * most.carried_m);
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float h = here[i];
    const float over = h - base[i], depth = over > 0 ? over : 0.0f;
    const float light = 2 - depth * per_fade;
    const float fading = light > 0 ? (light < 1 ? light : 1.0f) : 0.0f;
    const float drop_x = fading * (depth < most_x ? depth : most_x);
    const float drop_y = fading * (depth < most_y ? depth : most_y);
    const float across = weighted_rise(wx[i], here[i + 1] - h, drop_x) +
                         weighted_rise(wx[i - 1], here[i - 1] - h, drop_x);
    const float down =
        weighted_rise(wb[i], below[i] - h, drop_y) + weighted_rise(wa[i], above[i] - h, drop_y);
    head_m2_s2[i] = tension_m3_s2 * (across + down);
  }
}

PENTIMENTO_KERNEL
void foresee_row(const float* __restrict depth_m, const float* __restrict height_m, float carried_m,
                 int n, float* __restrict surface_m) {
  constexpr float kOfThin = 0.9f, kOfDeep = 0.5f;
  const float per_carried = 1 / carried_m;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float over = depth_m[i] * per_carried - 1;
    const float deep = over > 0 ? (over < 1 ? over : 1.0f) : 0.0f;
    const float share = kOfThin + (kOfDeep - kOfThin) * deep;
    surface_m[i] = height_m[i] + share * (surface_m[i] - height_m[i]);
  }
}

PENTIMENTO_KERNEL
void capillary_force_row(const CapillaryForce& p, const CapillaryFaces& f, int n,
                         float* __restrict velocity_m_s, float* __restrict held_m_s2) {
  constexpr float kLeast = 1e-30f;  // keeps a closed face from dividing by 0
  const float* __restrict weight = f.weight;
  const float* __restrict depth = f.depth_m;
  const float* __restrict mobility = f.mobility_frac;
  const float* __restrict friction = f.friction_frac;
  const float* __restrict head_a = f.head_a;
  const float* __restrict head_b = f.head_b;
  const float* __restrict height_a = f.height_a;
  const float* __restrict height_b = f.height_b;
  const float dt = p.dt_s;
  const float per_d = p.per_d_per_m;
  const float most = p.tension_m3_s2 * p.stiffest_per_m2;
  const float stiffness = dt * dt * p.stiffest_per_m2;
  const float hanging = p.hanging_m_s2;
  const float sagging = p.sagging_m_s2;
  const float per_carried = 1 / p.carried_m;
  const float stiffest = p.stiffest;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float k = weight[i] > 0 ? friction[i] * mobility[i] : 0.0f;
    const float coupling = stiffness * (k * depth[i]);
    const float stiff = most * coupling;
    const float share = stiff > stiffest ? stiffest / stiff : 1.0f;
    const float missing = share * stiff - 1;
    const float held = missing > 0 ? missing / (coupling > kLeast ? coupling : kLeast) : 0.0f;
    const float head = share * (head_b[i] - head_a[i]);
    const float rise = height_b[i] - height_a[i];
    const float pull = head + (held + hanging) * rise;
    velocity_m_s[i] += dt * k * (pull * per_d);
    const float over = depth[i] * per_carried - 1;
    const float sags = over > 0 ? (over < 1 ? over : 1.0f) : 0.0f;
    held_m_s2[i] = held + sagging * (k > 0 ? sags : 0.0f);
  }
}

}  // namespace pentimento::conservative

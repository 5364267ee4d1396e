#include "core/fluid/conservative/solve/drag_row.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {

namespace {
constexpr float kDamping = 2.0f / 3;

// The coupling to a face beside one with viscosity `nu`, over dt/dx^2.
inline float coupling(float nu, float nu_beside, float depth_beside) {
  const float wet = depth_beside > 0 ? 1.0f : 0.0f;
  const float dry = depth_beside == 0 ? 1.0f : 0.0f;
  return wet * (0.5f * (nu + nu_beside)) + dry * nu;
}
}  // namespace

PENTIMENTO_KERNEL
void drag_row(const DragFaces& before, const DragFaces& here, const DragFaces& after,
              const float* friction_frac, float per_d2, int n, float* response_frac) {
  const float* depth_before = before.depth_m;
  const float* depth_after = after.depth_m;
  const float* nu_before = before.viscosity_m2_s;
  const float* nu = here.viscosity_m2_s;
  const float* nu_after = after.viscosity_m2_s;
  const float* r_before = before.response_frac;
  const float* r = here.response_frac;
  const float* r_after = after.response_frac;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float f = friction_frac[i];
    const float c_before = per_d2 * coupling(nu[i], nu_before[i], depth_before[i]);
    const float c_after = per_d2 * coupling(nu[i], nu_after[i], depth_after[i]);
    const float pulled = 1 + (c_before * r_before[i] + c_after * r_after[i]);
    const float dragged = f * pulled / (1 + f * (c_before + c_after));
    response_frac[i] = (1 - kDamping) * r[i] + kDamping * dragged;
  }
}

}  // namespace pentimento::conservative

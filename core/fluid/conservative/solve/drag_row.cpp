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

// What all sweeps over a row have in common.
struct RowCouplings {
  float* before;
  float* after;
  float* resisted;  // 1 + f (before + after)
};

PENTIMENTO_KERNEL
void couplings_row(const float* depth, const float* nu, const float* __restrict friction,
                   float per_d2, int n, const RowCouplings& out) {
  float* __restrict before = out.before;
  float* __restrict after = out.after;
  float* __restrict resisted = out.resisted;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float c_before = per_d2 * coupling(nu[i], nu[i - 1], depth[i - 1]);
    const float c_after = per_d2 * coupling(nu[i], nu[i + 1], depth[i + 1]);
    before[i] = c_before;
    after[i] = c_after;
    resisted[i] = 1 + friction[i] * (c_before + c_after);
  }
}

// One sweep: drag_row() with couplings that are known.
PENTIMENTO_KERNEL
void coupled_row(const RowCouplings& c, const float* friction, const float* r, int n, float* out) {
  const float* __restrict before = c.before;
  const float* __restrict after = c.after;
  const float* __restrict resisted = c.resisted;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float pulled = 1 + (before[i] * r[i - 1] + after[i] * r[i + 1]);
    const float dragged = friction[i] * pulled / resisted[i];
    out[i] = (1 - kDamping) * r[i] + kDamping * dragged;
  }
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

void DragAlongRow::sweep(int sweeps, const float* depth_m, const float* viscosity_m2_s,
                         float per_d2, int n, float* friction_frac) {
  constexpr int kSide = 16;  // one cache line of floats: rows stay aligned
  if (n + 2 * kSide > couplings_.width()) {
    couplings_ = Field<float>(n + 2 * kSide, 3);
    response_ = Field<float>(n + 2 * kSide, 2);
  }
  const RowCouplings c{couplings_.row(0) + kSide, couplings_.row(1) + kSide,
                       couplings_.row(2) + kSide};
  couplings_row(depth_m, viscosity_m2_s, friction_frac, per_d2, n, c);
  const float* r = friction_frac;
  for (int k = 0; k < sweeps; ++k) {
    // The last sweep writes over the friction, which it reads in that place alone.
    float* out = k + 1 < sweeps ? response_.row(k % 2) + kSide : friction_frac;
    coupled_row(c, friction_frac, r, n, out);
    if (k + 1 < sweeps) out[n] = 0;  // a longer row may have left something there
    r = out;
  }
}

}  // namespace pentimento::conservative

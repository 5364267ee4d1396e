#include "core/fluid/conservative/advection/face_row.h"

#include <algorithm>

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {

inline float hydrostatic(float height_a, float height_b, float base_a, float base_b) {
  const float height = height_a > height_b ? height_a : height_b;
  const float base = base_a > base_b ? base_a : base_b;
  const float rise = height - base;
  return rise > 0 ? rise : 0.0f;
}

}  // namespace

PENTIMENTO_KERNEL
void face_row(const FaceParameters& p, const CellRow& a, const CellRow& b, int n,
              const FaceRow& out) {
  const float dry_film = p.dry_film_m;
  const float floor = p.viscosity_floor_m2_s;
  const float friction_dt = p.friction_dt_s;
  const float* __restrict depth_a = a.depth_m;
  const float* __restrict depth_b = b.depth_m;
  const float* __restrict base_a = a.base_m;
  const float* __restrict base_b = b.base_m;
  const float* __restrict nu_a = a.viscosity_m2_s;
  const float* __restrict nu_b = b.viscosity_m2_s;
  const float* __restrict height_a = a.height_m;
  const float* __restrict height_b = b.height_m;
  const float* __restrict mobility_a = a.mobility_frac;
  const float* __restrict mobility_b = b.mobility_frac;
  float* __restrict depth = out.depth_m;
  float* __restrict mobility = out.mobility_frac;
  float* __restrict viscosity = out.viscosity_m2_s;
  float* __restrict friction = out.friction_frac;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    // Masks as numbers: two conditions joined by `and` would keep the compiler from vectors.
    const float d_a = depth_a[i];
    const float d = hydrostatic(height_a[i], height_b[i], base_a[i], base_b[i]);
    const float sum = d_a + depth_b[i];
    const float least = d < sum ? d : sum;
    const float wet = least > 0 ? 1.0f : 0.0f;
    const float dry = 1 - wet;
    const float share = d_a / (wet * sum + dry);
    const float mean_mobility = share * mobility_a[i] + (1 - share) * mobility_b[i];
    const float mean_nu = share * nu_a[i] + (1 - share) * nu_b[i];
    const float nu = mean_nu > floor ? mean_nu : floor;
    const float d2 = wet * (d * d) + dry;
    const float left = d2 / (d2 + friction_dt * nu);
    depth[i] = wet * d;
    mobility[i] = d > dry_film ? mean_mobility : 0.0f;
    viscosity[i] = nu;
    friction[i] = wet * left;
  }
}

void close_faces_row(int n, const FaceRow& out) {
  for (float* p : {out.depth_m, out.mobility_frac, out.viscosity_m2_s, out.friction_frac})
    std::fill_n(p, n, 0.0f);
}

}  // namespace pentimento::conservative

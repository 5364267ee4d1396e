#include "core/fluid/conservative/face_row.h"

#include <algorithm>

#include "core/fluid/conservative/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void face_row(const FaceParameters& p, const CellRow& a, const CellRow& b, int n,
              const FaceRow& out) {
  const float dry_film = p.dry_film_m;
  const float floor = p.viscosity_floor_m2_s;
  const float friction_dt = p.friction_dt_s;
  float* __restrict depth = out.depth_m;
  float* __restrict mobility = out.mobility_frac;
  float* __restrict viscosity = out.viscosity_m2_s;
  float* __restrict friction = out.friction_frac;
  for (int i = 0; i < n; ++i) {
    const float height = a.height_m[i] > b.height_m[i] ? a.height_m[i] : b.height_m[i];
    const float base = a.base_m[i] > b.base_m[i] ? a.base_m[i] : b.base_m[i];
    const float d = height > base ? height - base : 0.0f;
    const float sum = a.depth_m[i] + b.depth_m[i];
    const bool wet = d > 0 && sum > 0;
    const float share = a.depth_m[i] / (wet ? sum : 1.0f);
    const float mean_mobility = share * a.mobility_frac[i] + (1 - share) * b.mobility_frac[i];
    const float mean_nu = share * a.viscosity_m2_s[i] + (1 - share) * b.viscosity_m2_s[i];
    const float nu = mean_nu > floor ? mean_nu : floor;
    const float d2 = wet ? d * d : 1.0f;
    depth[i] = wet ? d : 0.0f;
    mobility[i] = d > dry_film ? mean_mobility : 0.0f;
    viscosity[i] = nu;
    friction[i] = wet ? d2 / (d2 + friction_dt * nu) : 0.0f;
  }
}

void close_faces_row(int n, const FaceRow& out) {
  for (float* p : {out.depth_m, out.mobility_frac, out.viscosity_m2_s, out.friction_frac})
    std::fill_n(p, n, 0.0f);
}

}  // namespace pentimento::conservative

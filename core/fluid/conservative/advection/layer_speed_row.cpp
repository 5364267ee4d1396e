#include "core/fluid/conservative/advection/layer_speed_row.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void layer_middle_row(const float* __restrict layer, const float* __restrict total, int n,
                      float* __restrict below, float* __restrict middle) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const bool some = layer[i] > 0;
    const float under = below[i];
    const float at = (under + 0.5f * layer[i]) / (some ? total[i] : 1.0f);
    middle[i] = some ? at : 0.0f;
    below[i] = under + layer[i];
  }
}

PENTIMENTO_KERNEL
void layer_speed_row(float speed, const float* __restrict middle_a,
                     const float* __restrict middle_b, const float* __restrict flow,
                     const float* __restrict push, int edges, float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int e = 0; e < edges; ++e) {
    const float a = middle_a[e];
    const float b = middle_b[e];
    const float both = (a > 0 ? 1.0f : 0.0f) * (b > 0 ? 1.0f : 0.0f);
    const float factor = (a + b) * (1 - 0.5f * both);
    out[e] = (speed * flow[e] + push[e]) * factor;
  }
}

}  // namespace pentimento::conservative

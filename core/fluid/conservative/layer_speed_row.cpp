#include "core/fluid/conservative/layer_speed_row.h"

#include "core/fluid/conservative/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void layer_speed_row(const LayerSpeed& p, const float* __restrict layers_a,
                     const float* __restrict layers_b, const float* __restrict flow,
                     const float* __restrict push, int edges, float* __restrict out) {
  const auto below = static_cast<float>(p.layer);  // n > k: the cell has layer k
  const float middle = below + 0.5f;
  const float speed = p.speed;
  PENTIMENTO_INDEPENDENT
  for (int e = 0; e < edges; ++e) {
    const float a = layers_a[e];
    const float b = layers_b[e];
    const bool has_a = a > below;
    const bool has_b = b > below;
    const float of_a = has_a ? middle / (has_a ? a : 1.0f) : 0.0f;
    const float of_b = has_b ? middle / (has_b ? b : 1.0f) : 0.0f;
    const float factor = has_a && has_b ? 0.5f * (of_a + of_b) : of_a + of_b;
    out[e] = (speed * flow[e] + push[e]) * factor;
  }
}

}  // namespace pentimento::conservative

#include "core/detail/flow/level_rows.h"

#include "core/base/kernel.h"

namespace pentimento {

namespace {
// Where a pigment's profile rises, and how far.
constexpr float kStainLow = 0.35f, kStainRise = 0.4f;
constexpr float kEdgeReach = 4;  // pigment relaxes where its coverage is below 1, fully at 3/4

/// a / b where b > 0, else 0, without a branch.
inline __attribute__((always_inline)) float share(float a, float b) {
  const float positive = b > 0 ? b : 1.0f;
  return b > 0 ? a / positive : 0.0f;
}
}  // namespace

PENTIMENTO_KERNEL
void relax_depth_row(const LevelRow& guide, const float* base_m, int n, float* __restrict depth_m) {
  const float *rate = guide.rate, *wet = guide.wet, *depth = guide.depth_m, *base = guide.base_m;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float surface = share(depth[i], wet[i]) + base[i] - base_m[i];
    const float target = edge_profile(wet[i]) * (surface > 0 ? surface : 0.0f);
    depth_m[i] += rate[i] * (target - depth_m[i]);
  }
}

PENTIMENTO_KERNEL
void relax_pigment_row(const LevelRow& guide, const LevelPigmentRow& pigment, const float* before_m,
                       const float* after_m, int n, float* __restrict amount) {
  const float *rate = guide.rate, *film = pigment.depth_m;
  const float *smooth = pigment.amount, *coverage = pigment.coverage;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float gained = after_m[i] - before_m[i];
    const float kept = gained < 0 ? share(after_m[i], before_m[i]) : 1.0f;
    const float brought = gained < 0 ? 0.0f : gained * share(smooth[i], film[i]);
    const float carried = amount[i] * kept + brought;
    const float reach = kEdgeReach * (1 - coverage[i]), edge = reach < 1 ? reach : 1.0f;
    const float target =
        rising_profile(coverage[i], kStainLow, kStainRise) * share(smooth[i], coverage[i]);
    const float pull = coverage[i] > 0 && edge > 0 ? rate[i] * edge : 0.0f;
    amount[i] = carried + pull * (target - carried);
  }
}

}  // namespace pentimento

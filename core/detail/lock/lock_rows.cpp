#include "core/detail/lock/lock_rows.h"

#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr float kClose = 1e-6f;     // the mean of a block in floats is not more exact than this
constexpr float kMostSmoothed = 2;  // larger ratios would pull their neighbours along
constexpr float kMostScaled = 16;   // blocks that must grow by more are filled instead

/// How many of the blocks of which neither is 0 are off by more than `bound`.
PENTIMENTO_KERNEL
int count_off(const float* wanted, const float* held, float bound, int n) {
  int count = 0;
  for (int i = 0; i < n; ++i) {
    const bool both = wanted[i] > 0 && held[i] > 0;
    const float r = wanted[i] / (both ? held[i] : 1.0f);
    const float off = r < 1 ? 1 - r : r - 1;
    count += both && off > bound ? 1 : 0;
  }
  return count;
}
}  // namespace

PENTIMENTO_KERNEL
bool ratio_row(const BlockTargets& to, int n, float* __restrict ratio) {
  const float *wanted = to.wanted, *held = to.held;
  int any = 0;  // not a bool, which keeps the loop from being a vector's
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const bool both = wanted[i] > 0 && held[i] > 0;
    const float r = wanted[i] / (both ? held[i] : 1.0f);
    const bool close = r > 1 - kClose && r < 1 + kClose;
    const bool far = r < 1 / kMostSmoothed || r > kMostSmoothed;
    const bool smoothed = both && !close && !far;
    ratio[i] = smoothed ? r : 1.0f;
    any |= smoothed ? 1 : 0;
  }
  return any != 0;
}

float share_of_own_centre(int factor) {
  // Cells lie (i + 1/2) / factor - 1/2 off the centre. The mean of that, unsigned, is what
  // neighbours get.
  const auto k = static_cast<float>(factor);
  const float neighbours = factor % 2 == 0 ? 0.25f : 0.25f * (1 - 1 / (k * k));
  return 1 - neighbours;
}

PENTIMENTO_KERNEL
void sharpen_row(const BlockTargets& to, const RatioRows& field, float own, int n,
                 float* __restrict out) {
  const float *wanted = to.wanted, *held = to.held;
  const float *above = field.above, *here = field.here, *below = field.below;
  const float beside = 0.5f * (1 - own);
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float over = own * above[i] + beside * (above[i - 1] + above[i + 1]);
    const float level = own * here[i] + beside * (here[i - 1] + here[i + 1]);
    const float under = own * below[i] + beside * (below[i - 1] + below[i + 1]);
    const float mean = own * level + beside * (over + under);
    const bool both = wanted[i] > 0 && held[i] > 0;
    const float left = wanted[i] / (both ? held[i] * mean : 1.0f);
    const bool far = left < 1 / kMostSmoothed || left > kMostSmoothed;
    const bool close = left > 1 - kClose && left < 1 + kClose;
    out[i] = here[i] * (both && !far && !close ? left : 1.0f);
  }
}

void count_ratios(const BlockTargets& to, int n, RatioCounts& counts) {
  constexpr float kBelowAll = -1;
  int more = count_off(to.wanted, to.held, kBelowAll, n);
  for (std::size_t bin = 0; bin < kRatioBounds.size() && more > 0; ++bin) {
    const int beyond = count_off(to.wanted, to.held, kRatioBounds[bin], n);
    counts[bin] += more - beyond;
    more = beyond;
  }
  counts.back() += more;
}

PENTIMENTO_KERNEL
bool exact_row(const BlockTargets& to, int n, float* __restrict scale,
               std::uint8_t* __restrict owed) {
  const float *wanted = to.wanted, *held = to.held;
  int any = 0;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const bool some = wanted[i] > 0, enough = wanted[i] <= kMostScaled * held[i];
    const float r = wanted[i] / (some && enough ? held[i] : 1.0f);
    const float nothing = held[i] > 0 ? 0.0f : 1.0f;
    const float by = !some ? nothing : enough ? r : 1.0f;
    scale[i] = by;
    owed[i] = some && !enough ? 1 : 0;
    any |= by != 1 ? 1 : 0;
  }
  return any != 0;
}

}  // namespace pentimento

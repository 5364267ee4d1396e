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

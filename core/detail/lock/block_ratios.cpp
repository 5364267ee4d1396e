#include "core/detail/lock/block_ratios.h"

#include <algorithm>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
PENTIMENTO_KERNEL
void look_up(const float* ratio, const std::int32_t* place, int n, float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = ratio[place[i]];
}
}  // namespace

void BlockRatios::clear() {
  for (const BlockStrip& s : strips_) std::fill(place_.row(s.y) + s.x0, place_.row(s.y) + s.x1, 0);
  strips_.clear();
  blocks_ = 0;
}

void BlockRatios::add(const BlockStrip& strip) {
  strips_.push_back(strip);
  for (int x = strip.x0; x < strip.x1; ++x)
    place_(x, strip.y) = static_cast<std::int32_t>(++blocks_);
}

void BlockRatios::read(std::size_t plane, const BlockStrip& strip, RatiosAround& out) const {
  const float* ratio = ratio_.data() + plane * (blocks_ + 1);
  const int before = std::max(strip.x0 - 1, 0), after = std::min(strip.x1, place_.width() - 1);
  for (int row = 0; row < 3; ++row) {
    const std::int32_t* place = place_.row(std::clamp(strip.y + row - 1, 0, place_.height() - 1));
    out.at(row, -1) = ratio[place[before]];
    look_up(ratio, place + strip.x0, strip.blocks(), &out.at(row, 0));
    out.at(row, strip.blocks()) = ratio[place[after]];
  }
}

}  // namespace pentimento

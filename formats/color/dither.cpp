#include "formats/color/dither.h"

#include <algorithm>
#include <array>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr std::size_t kDitheredTogether = 64;  // pixels

/// dither_uniform() of the pixels from x on.
PENTIMENTO_KERNEL
void uniform_row(int x, int y, int channel, int n, std::int32_t* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = dither_uniform(x + i, y, channel);
}

/// `uniform` begins with the pixel to the left.
PENTIMENTO_KERNEL
void dither_codes(const std::int32_t* uniform, int n, int* __restrict code) {
  constexpr int kHalf = kStepsPerCode / 2;
  for (int i = 0; i < n; ++i) {
    const int here = uniform[i + 1], left = uniform[i];
    const bool at_an_end = code[i] < kHalf || code[i] > 65535 - kHalf;
    const int noise = here - (at_an_end ? kHalf : left);
    code[i] = static_cast<int>(static_cast<unsigned>(code[i] + noise + kHalf) / kStepsPerCode);
  }
}
}  // namespace

void dither_row(int x, int y, int channel, std::span<int> code) {
  std::array<std::int32_t, kDitheredTogether + 1> uniform;
  for (std::size_t done = 0; done < code.size(); done += kDitheredTogether) {
    const int n = static_cast<int>(std::min(kDitheredTogether, code.size() - done));
    uniform_row(x + static_cast<int>(done) - 1, y, channel, n + 1, uniform.data());
    dither_codes(uniform.data(), n, code.data() + done);
  }
}

}  // namespace pentimento

#include "core/detail/fine_edges.h"

#include <algorithm>

namespace pentimento {

bool blend_edges(std::span<const float> a, std::span<const float> b, float t,
                 std::span<float> out) {
  bool moves = false;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = a[i] + t * (b[i] - a[i]);
    moves |= out[i] != 0;
  }
  return moves;
}

void place_edges(std::span<const float> guide, int factor, std::span<float> position) {
  constexpr float kSliver = 1.0f / 64;
  const auto k = static_cast<std::size_t>(factor);
  const std::size_t blocks = guide.size() - 1;
  for (std::size_t g = 0; g < blocks; ++g) {
    const float low = guide[g] * static_cast<float>(factor);
    const float rise = (guide[g + 1] - guide[g]);  // k D over k cells
    for (std::size_t i = 0; i < k; ++i)
      position[g * k + i] = static_cast<float>(g * k + i) + (low + rise * static_cast<float>(i));
  }
  const std::size_t last = blocks * k;
  position[last] = static_cast<float>(last);
  for (std::size_t e = 1; e <= last; ++e)
    position[e] = std::max(position[e], position[e - 1] + kSliver);
  position[last] = static_cast<float>(last);
  for (std::size_t e = last; e-- > 0;)
    position[e] = std::min(position[e], position[e + 1] - kSliver);
  position[0] = 0;
}

}  // namespace pentimento

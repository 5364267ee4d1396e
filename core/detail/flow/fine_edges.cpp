#include "core/detail/flow/fine_edges.h"

#include <algorithm>

#include "core/fluid/conservative/advection/limiter.h"

namespace pentimento {

namespace {
/// Slope of the displacement at an edge of the guide, per block. It is 0 at both ends of the line
/// and beside edges that stand still.
float slope_at(std::span<const float> guide, std::size_t edge) {
  if (edge == 0 || edge + 1 == guide.size()) return 0;
  return conservative::limited_mc(guide[edge] - guide[edge - 1], guide[edge + 1] - guide[edge]);
}
}  // namespace

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
  const float per_factor = 1 / static_cast<float>(factor);
  const std::size_t blocks = guide.size() - 1;
  // Between two edges of the guide, a cubic with limited slopes.
  for (std::size_t g = 0; g < blocks; ++g) {
    const float low = guide[g], rise = guide[g + 1] - guide[g];
    const float slope_low = slope_at(guide, g), slope_high = slope_at(guide, g + 1);
    for (std::size_t i = 0; i < k; ++i) {
      const float t = static_cast<float>(i) * per_factor;
      const float cubic = t * (1 - t) * ((1 - t) * (slope_low - rise) + t * (rise - slope_high));
      const float moved = low + t * rise + cubic;
      position[g * k + i] = static_cast<float>(g * k + i) + moved * static_cast<float>(factor);
    }
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

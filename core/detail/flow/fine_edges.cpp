#include "core/detail/flow/fine_edges.h"

#include <algorithm>

#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/limiter.h"

namespace pentimento {

namespace {
constexpr float kSliver = 1.0f / 64;  // fine cells that are kept between two edges

/// Slope of the displacement at an edge of the guide, per block. It is 0 at both ends of the line
/// and beside edges that stand still.
float slope_at(std::span<const float> guide, std::size_t edge) {
  if (edge == 0 || edge + 1 == guide.size()) return 0;
  return conservative::limited_mc(guide[edge] - guide[edge - 1], guide[edge + 1] - guide[edge]);
}

/// Places the edges of a block, from its first fine cell on.
PENTIMENTO_KERNEL
void place_block(float low, float rise, float slope_low, float slope_high, int first, int factor,
                 float per_factor, float* __restrict position) {
  const float k = static_cast<float>(factor), from_low = slope_low - rise,
              from_high = rise - slope_high;
  for (int i = 0; i < factor; ++i) {
    const float t = static_cast<float>(i) * per_factor;
    const float cubic = t * (1 - t) * ((1 - t) * from_low + t * from_high);
    const float moved = low + t * rise + cubic;
    position[first + i] = static_cast<float>(first + i) + moved * k;
  }
}

/// Whether push_apart() would move any edge, but for rounding: the last is where it belongs.
PENTIMENTO_KERNEL
bool any_too_near(const float* position, int last) {
  int near = 0;
  for (int e = 0; e < last; ++e)
    near |= static_cast<int>(position[e + 1] < position[e] + kSliver) |
            static_cast<int>(position[e] > position[e + 1] - kSliver);
  return near != 0;
}

/// Makes the edges ascend, from the left, then from the right wall.
void push_apart(std::span<float> position) {
  const std::size_t last = position.size() - 1;
  for (std::size_t e = 1; e <= last; ++e)
    position[e] = std::max(position[e], position[e - 1] + kSliver);
  position[last] = static_cast<float>(last);
  for (std::size_t e = last; e-- > 0;)
    position[e] = std::min(position[e], position[e + 1] - kSliver);
  position[0] = 0;
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
  const auto k = static_cast<std::size_t>(factor);
  const float per_factor = 1 / static_cast<float>(factor);
  const std::size_t blocks = guide.size() - 1, last = blocks * k;
  // Between two edges of the guide, a cubic with limited slopes.
  float slope_low = slope_at(guide, 0);
  for (std::size_t g = 0; g < blocks; ++g) {
    const float slope_high = slope_at(guide, g + 1);
    place_block(guide[g], guide[g + 1] - guide[g], slope_low, slope_high, static_cast<int>(g * k),
                factor, per_factor, position.data());
    slope_low = slope_high;
  }
  position[last] = static_cast<float>(last);
  // Few lines have edges that would cross.
  if (any_too_near(position.data(), static_cast<int>(last))) push_apart(position);
}

}  // namespace pentimento

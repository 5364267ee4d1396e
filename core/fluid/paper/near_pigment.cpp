#include "core/fluid/paper/near_pigment.h"

#include "core/base/kernel.h"
#include "core/fluid/paper/pigment.h"

namespace pentimento::paper {

PENTIMENTO_KERNEL
void layer_shares(int layer, const std::uint8_t* __restrict occupied, int n,
                  float* __restrict share) {
  const float in_film = static_cast<float>(layer) + 0.5f;
  for (int i = 0; i < n; ++i) {
    const std::int32_t layers = occupied[i];
    share[i] = in_film / static_cast<float>(layers > layer ? layers : layer + 1);
  }
}

PENTIMENTO_KERNEL
void arrive_near(const NearDepartures& departures, const NearRows& given, int n,
                 float* __restrict arrived) {
  const NearRows plane = given;
  for (int i = 0; i < n; ++i) {
    const float value = interpolate_near(
        departures, i, [&](int row, int column) { return value_near(plane, i, row, column); });
    const bool moves = departures.moves[static_cast<std::size_t>(i)] != 0;
    arrived[i] = moves ? without_tail(value) : plane.here[i];
  }
}

PENTIMENTO_KERNEL
void arrive_near_free(const NearDepartures& departures, const NearRows& given,
                      const NearRows& given_free, int n, float* __restrict arrived) {
  const NearRows plane = given, free = given_free;
  for (int i = 0; i < n; ++i) {
    const float value = interpolate_near(departures, i, [&](int row, int column) {
      return value_near(plane, i, row, column) * value_near(free, i, row, column);
    });
    const float stays = (1.0f - free.here[i]) * plane.here[i];
    const bool moves = departures.moves[static_cast<std::size_t>(i)] != 0;
    arrived[i] = moves ? without_tail(value + stays) : plane.here[i];
  }
}

}  // namespace pentimento::paper

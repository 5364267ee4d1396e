#pragma once
// The canvas on which the conservative scheme is measured: wet all over, and never at rest.

#include <array>
#include <utility>

#include "tests/core/fluid/conservative/basin.h"

namespace pentimento::conservative {

/// Runny paint of uneven depth and stiffness on the cells [0, wet) x [0, wet * height / width) of a
/// canvas of `width` cells, 4:3, 1024 cells to a metre: 2 layers, 4 channels, all of one stroke,
/// tilted so that nothing can sleep, five steps on its way. `wet` at most `width`; the rest is
/// bare.
inline Basin running_canvas(int width, int wet, int threads) {
  const int height = width * 3 / 4;
  Basin b({width, height, width / 1024.0, height / 1024.0}, 2, 4, threads);
  b.gravity_m_s2 = {2, -3, 9};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      b.state.base_m(x, y) = 1e-4f * static_cast<float>((x * 7 + y * 5) % 4);
      if (x >= wet || y >= wet * 3 / 4) continue;
      const float d = 0.002f + 0.0004f * static_cast<float>((x / 8 + 2 * (y / 8)) % 5);
      b.state.depth_m(x, y) = d;
      b.state.stroke(x, y) = 1;
      for (int k = 0; k < 2; ++k)
        for (int c = 0; c < 4; ++c)
          b.state.channel(k, c)(x, y) = 0.25f * d * static_cast<float>(k + 1);
    }
  b.steps(5);
  return b;
}

/// Gravity that walks round once in two seconds: the paint never comes to rest.
inline void turn(Basin& b, int step) {
  constexpr std::array<float, 8> kCircle = {0, 0.7071f, 1, 0.7071f, 0, -0.7071f, -1, -0.7071f};
  const auto at = static_cast<std::size_t>(step / 11);
  b.gravity_m_s2 = {4 * kCircle[at % 8], 4 * kCircle[(at + 2) % 8], 9};
}

}  // namespace pentimento::conservative

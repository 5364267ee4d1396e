#pragma once
// Smooth steps and noise for drawing tips. They use only + - * /, so they are the same bits
// everywhere.

#include <algorithm>
#include <cstdint>

#include "core/base/random.h"

namespace pentimento {

/// 0 for x <= `from`, 1 for x >= `to`, 3t^2 - 2t^3 between them. from < to.
inline float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// Smooth noise in [0,1) of one variable, x >= -4096, with about one bump per unit. Another `track`
/// is other noise.
inline float tip_noise(float x, std::uint64_t seed, std::uint64_t track) {
  const float shifted = x + 4096;
  const auto cell = static_cast<std::uint64_t>(shifted);
  const float t = shifted - static_cast<float>(cell);
  const std::uint64_t counter = (track << 32) + cell;
  const float a = random_uniform(RandomPurpose::kBristle, seed, counter);
  const float b = random_uniform(RandomPurpose::kBristle, seed, counter + 1);
  return a + (b - a) * t * t * (3 - 2 * t);
}

/// The same of two variables, both >= -4096.
inline float tip_noise(float x, float y, std::uint64_t seed, std::uint64_t track) {
  const float shifted = y + 4096;
  const auto row = static_cast<std::uint64_t>(shifted);
  const float t = shifted - static_cast<float>(row);
  const float a = tip_noise(x, seed, (track << 16) + row);
  const float b = tip_noise(x, seed, (track << 16) + row + 1);
  return a + (b - a) * t * t * (3 - 2 * t);
}

}  // namespace pentimento

#include "core/brush/tip_shapes.h"

#include <algorithm>
#include <cmath>

#include "core/brush/resample.h"
#include "core/math/random.h"

namespace pentimento {

namespace {
constexpr float kFlatLength = 0.3f;  // of the width
constexpr float kFilbertLength = 0.5f;
constexpr float kBristleLength = 0.6f;
constexpr float kKnifeLength = 0.14f;
constexpr int kBristles = 150;

/// 0 up to `from`, 1 from `to` on, 3t^2 - 2t^3 between.
float smooth_step(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

/// Smooth noise in [0,1) of one variable, about one bump per unit; `track` keeps uses apart.
float noise(float x, std::uint64_t seed, std::uint64_t track) {
  const float shifted = x + 4096;
  const auto cell = static_cast<std::uint64_t>(shifted);
  const float t = shifted - static_cast<float>(cell);
  const std::uint64_t counter = (track << 32) + cell;
  const float a = random_uniform(RandomPurpose::kBristle, seed, counter);
  const float b = random_uniform(RandomPurpose::kBristle, seed, counter + 1);
  return a + (b - a) * t * t * (3 - 2 * t);
}

/// How much paint the hairs at v hold, 1 on average, within 1 +- unevenness.
float hair_load(float v, float unevenness, std::uint64_t seed) {
  const float coarse = noise(v * 9, seed, 0) - 0.5f;
  const float fine = noise(v * 23, seed, 1) - 0.5f;
  return 1 + unevenness * (1.2f * coarse + 0.8f * fine);
}

/// Paint is squeezed out to the sides and stands there as a ridge.
float side_ridge(float v) {
  return 1 + 0.35f * smooth_step(0.7f, 0.88f, std::abs(v));
}

/// How much longer than the mean the hairs at v are, within +-1.
float hair_length(float v, std::uint64_t seed) {
  return 2 * (0.6f * noise(v * 14, seed, 2) + 0.4f * noise(v * 37, seed, 3)) - 1;
}

/// Value of a shape at (u, v), both in [-1, 1] (halves of the diameter).
float shape_value(TipShape shape, float u, float v, std::uint64_t seed) {
  switch (shape) {
    case TipShape::kRound: {
      const float r = std::sqrt(u * u + v * v) * (1 - 0.06f * hair_length(v, seed));
      return (1 - smooth_step(0.62f, 0.94f, r)) * hair_load(v, 0.45f, seed) / 1.45f;
    }
    case TipShape::kFlat: {
      const float along = std::abs(u) / (kFlatLength * (0.85f + 0.15f * hair_length(v, seed)));
      const float across = std::abs(v);
      return (1 - smooth_step(0.6f, 1, along)) * (1 - smooth_step(0.93f, 1, across)) *
             hair_load(v, 0.6f, seed) * side_ridge(v) / 2.2f;
    }
    case TipShape::kFilbert: {
      const float x = u / kFilbertLength;
      const float r = std::sqrt(x * x + v * v) * (1 - 0.08f * hair_length(v, seed));
      return (1 - smooth_step(0.7f, 1, r)) * hair_load(v, 0.5f, seed) * side_ridge(v) / 2.1f;
    }
    case TipShape::kKnife: {
      const float along = std::abs(u) / kKnifeLength;
      const float across = std::abs(v);
      // Paint is squeezed out to the ends of the blade.
      const float ridge = smooth_step(0.8f, 0.95f, across);
      return (1 - smooth_step(0.7f, 1, along)) * (1 - smooth_step(0.97f, 1, across)) *
             (0.6f + 0.4f * ridge);
    }
    case TipShape::kBristle:
    case TipShape::kTexture:
      break;
  }
  return 0;
}

/// Coarse hog hair: clumps of bristles of uneven size and load over a thin film.
float bristle_film(float u, float v, std::uint64_t seed) {
  const float x = u / kBristleLength;
  const float r = std::sqrt(x * x + v * v) * (1 - 0.1f * hair_length(v, seed));
  return 0.1f * (1 - smooth_step(0.75f, 0.95f, r));
}

void draw_bristle(std::uint64_t seed, int index, Field<float>& map) {
  const auto uniform = [&](std::uint64_t k) {
    return random_uniform(RandomPurpose::kBristle, seed,
                          (std::uint64_t{9} << 32) + static_cast<std::uint64_t>(index) * 8 + k);
  };
  // Uniform in the square; what falls outside the ellipse is pulled in, so that the rim is denser,
  // as in a brush that has been used.
  float u = 2 * uniform(0) - 1;
  float v = 2 * uniform(1) - 1;
  const float r = std::sqrt(u * u + v * v);
  const float radius = 0.025f + 0.05f * uniform(2);
  const float pull = r > 0.92f ? (0.6f + 0.32f * uniform(4)) / r : 1.0f;
  u *= pull * (kBristleLength - radius);
  v *= pull * (1 - radius);
  const float lateral = hair_load(v, 0.9f, seed);
  const float load =
      std::clamp((0.25f + 0.75f * uniform(3)) * 0.6f * lateral * side_ridge(v), 0.0f, 1.0f);

  const int size = map.width();
  const auto texel = [&](float x) { return (x + 1) * 0.5f * static_cast<float>(size) - 0.5f; };
  const int reach = static_cast<int>(radius * 0.5f * static_cast<float>(size)) + 2;
  const int cx = static_cast<int>(texel(u)), cy = static_cast<int>(texel(v));
  for (int y = std::max(0, cy - reach); y <= std::min(size - 1, cy + reach); ++y) {
    for (int x = std::max(0, cx - reach); x <= std::min(size - 1, cx + reach); ++x) {
      const float dx = (static_cast<float>(x) - texel(u)) * 2 / static_cast<float>(size);
      const float dy = (static_cast<float>(y) - texel(v)) * 2 / static_cast<float>(size);
      const float edge = 1 - smooth_step(0.4f, 1, std::sqrt(dx * dx + dy * dy) / radius);
      map(x, y) = std::max(map(x, y), load * edge);
    }
  }
}

Field<float> draw_shape(TipShape shape, int size, std::uint64_t seed) {
  Field<float> map(size, size);
  constexpr int kSamples = 2;  // per texel and axis
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      float sum = 0;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const auto place = [&](int texel, int sub) {
          const float at = static_cast<float>(texel) +
                           (static_cast<float>(sub) + 0.5f) / static_cast<float>(kSamples);
          return 2 * at / static_cast<float>(size) - 1;
        };
        const float u = place(x, k % kSamples), v = place(y, k / kSamples);
        sum +=
            shape == TipShape::kBristle ? bristle_film(u, v, seed) : shape_value(shape, u, v, seed);
      }
      map(x, y) = sum / static_cast<float>(kSamples * kSamples);
    }
  }
  if (shape == TipShape::kBristle)
    for (int i = 0; i < kBristles; ++i) draw_bristle(seed, i, map);
  return map;
}
}  // namespace

TipExtent tip_extent(TipShape shape) {
  switch (shape) {
    case TipShape::kFlat:
      return {kFlatLength, 1};
    case TipShape::kFilbert:
      return {kFilbertLength * 1.1f, 1};
    case TipShape::kBristle:
      return {kBristleLength * 1.1f, 1};
    case TipShape::kKnife:
      return {kKnifeLength, 1};
    case TipShape::kRound:
    case TipShape::kTexture:
      break;
  }
  return {1, 1};
}

float hair_grip(TipShape shape, float v, std::uint64_t seed) {
  if (shape == TipShape::kKnife || shape == TipShape::kTexture) return 1;
  const float wave = 0.65f * noise(v * 7, seed, 4) + 0.35f * noise(v * 19, seed, 5);
  // Hairs hold on or slide, with little between.
  const float sharp = smooth_step(0.2f, 0.8f, wave);
  return 2 * sharp;
}

Field<float> draw_tip(const BrushDefinition& brush, int size, std::uint64_t seed) {
  if (brush.shape == TipShape::kTexture) return resample_area(brush.texture, size, size);
  return draw_shape(brush.shape, size, seed);
}

}  // namespace pentimento

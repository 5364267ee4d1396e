#include "core/brush/tip_shapes.h"

#include <algorithm>
#include <cmath>

#include "core/brush/noise.h"
#include "core/brush/resample.h"
#include "core/brush/tuft.h"

namespace pentimento {

namespace {
constexpr float kKnifeLength = 0.14f;  // of the width

/// Paint is squeezed out to the ends of the blade.
float knife_value(float u, float v) {
  const float along = std::abs(u) / kKnifeLength;
  const float across = std::abs(v);
  const float ridge = smooth_step(0.8f, 0.95f, across);
  return (1 - smooth_step(0.7f, 1, along)) * (1 - smooth_step(0.97f, 1, across)) *
         (0.6f + 0.4f * ridge);
}

/// A crumpled cloth: a ragged patch with folds that do not touch.
float rag_value(float u, float v, std::uint64_t seed) {
  const float edge = 0.3f * (tip_noise(3 * u, 3 * v, seed, 20) - 0.5f);
  const float fold =
      0.6f * tip_noise(4 * u, 4 * v, seed, 21) + 0.4f * tip_noise(9 * u, 9 * v, seed, 22);
  const float inside = 1 - smooth_step(0.6f, 0.92f, std::sqrt(u * u + v * v) + edge);
  return inside * (0.25f + 0.75f * smooth_step(0.3f, 0.65f, fold));
}

/// A shape without bristles, sampled 2 x 2 times per texel.
Field<float> draw_plain(TipShape shape, int size, std::uint64_t seed) {
  Field<float> map(size, size);
  constexpr int kSamples = 2;
  const auto place = [&](int texel, int sub) {
    const float at =
        static_cast<float>(texel) + (static_cast<float>(sub) + 0.5f) / static_cast<float>(kSamples);
    return 2 * at / static_cast<float>(size) - 1;
  };
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      float sum = 0;
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const float u = place(x, k % kSamples), v = place(y, k / kSamples);
        sum += shape == TipShape::kKnife ? knife_value(u, v) : rag_value(u, v, seed);
      }
      map(x, y) = sum / static_cast<float>(kSamples * kSamples);
    }
  }
  return map;
}
}  // namespace

bool has_bristles(const BrushDefinition& brush) {
  return brush.bristles.count > 0;
}

Field<float> draw_tip(const BrushDefinition& brush, int size, std::uint64_t seed, float press) {
  if (!has_bristles(brush)) {
    return brush.shape == TipShape::kTexture ? resample_area(brush.texture, size, size)
                                             : draw_plain(brush.shape, size, seed);
  }
  Tuft tuft = tuft_of(brush.shape);
  tuft.bristles = brush.bristles;
  Field<float> map = draw_tuft(tuft, make_bristles(tuft, seed), press, size);
  if (brush.shape != TipShape::kTexture) return map;
  const Field<float> light = resample_area(brush.texture, size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) map(x, y) *= light(x, y);
  return map;
}

float bristle_grip(const BrushDefinition& brush, float v, std::uint64_t seed) {
  if (!has_bristles(brush)) return 1;
  const float wave = 0.65f * tip_noise(v * 7, seed, 4) + 0.35f * tip_noise(v * 19, seed, 5);
  // Bristles hold on or slide, with little between.
  return 1 + brush.grip * (2 * smooth_step(0.2f, 0.8f, wave) - 1);
}

float bristle_supply(float v, float density_frac, std::uint64_t seed) {
  const float wave = 0.5f * tip_noise(v * 9, seed, 6) + 0.5f * tip_noise(v * 23, seed, 7);
  const float small = smooth_step(0.2f, 0.8f, wave);  // holds little: runs dry early
  return std::clamp((density_frac - 0.6f * small) * 4 + 0.2f, 0.0f, 1.0f);
}

}  // namespace pentimento

#include "core/brush/reservoir.h"

#include <algorithm>

namespace pentimento {

namespace {
constexpr int kPadding = 4;       // floats: a texel is whole vectors
constexpr float kTrace = 1e-20f;  // less is nothing: subnormal numbers are slow
}  // namespace

Reservoir::Reservoir(int channels)
    : stride_((1 + channels + kPadding - 1) / kPadding * kPadding),
      data_(static_cast<std::size_t>(stride_) * kReservoirSide * kReservoirSide, 0.0f) {}

void Reservoir::fill(const PaintLoad& load) {
  PENTIMENTO_CHECK(static_cast<int>(load.paint.size()) <= stride_);
  for (int i = 0; i < kReservoirSide * kReservoirSide; ++i)
    std::copy(load.paint.begin(), load.paint.end(), texel(i));
}

void Reservoir::sample(float u, float v, float* out) const {
  constexpr float kLast = kReservoirSide - 1;
  const float x = std::clamp((u + 0.5f) * kReservoirSide - 0.5f, 0.0f, kLast);
  const float y = std::clamp((v + 0.5f) * kReservoirSide - 0.5f, 0.0f, kLast);
  const int i = std::min(static_cast<int>(x), kReservoirSide - 2);
  const int j = std::min(static_cast<int>(y), kReservoirSide - 2);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const float* a = texel(j * kReservoirSide + i);
  const float* b = a + stride_;
  const float* c = texel((j + 1) * kReservoirSide + i);
  const float* d = c + stride_;
  blend_texels(a, b, c, d, {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}, stride_,
               out);
}

void Reservoir::refill(const PaintLoad& load, const Tip& tip, float refill_frac) {
  if (!(load.content_m > 0) || refill_frac == 0) return;
  for (const TipTexel& t : tip.texels()) {
    float* paint = texel(t.index);
    const float scale = std::max(1.0f, load.content_of(paint) / load.content_m);
    for (std::size_t k = 0; k < load.paint.size(); ++k) {
      const float mixed = paint[k] + refill_frac * (load.paint[k] * scale - paint[k]);
      paint[k] = mixed < kTrace ? 0 : mixed;
    }
  }
}

double Reservoir::weighted_surplus(const PaintLoad& load, const Tip& tip) const {
  double sum = 0;
  for (const TipTexel& t : tip.texels())
    sum += static_cast<double>(t.weight *
                               std::max(0.0f, load.content_of(texel(t.index)) - load.content_m));
  return sum;
}

void Reservoir::drop_surplus(const PaintLoad& load, const Tip& tip, float frac) {
  for (const TipTexel& t : tip.texels()) {
    float* paint = texel(t.index);
    const float content = load.content_of(paint);
    if (!(content > load.content_m)) continue;
    const float share = std::min(1.0f, frac * t.weight) * (content - load.content_m) / content;
    for (std::size_t k = 0; k < load.paint.size(); ++k) paint[k] -= share * paint[k];
  }
}

}  // namespace pentimento

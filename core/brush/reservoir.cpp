#include "core/brush/reservoir.h"

#include <algorithm>

namespace pentimento {

namespace {
constexpr int kPadding = 4;       // floats: a texel is whole vectors
constexpr float kTrace = 1e-20f;  // less is nothing: subnormal numbers are slow
}  // namespace

Reservoir::Reservoir(int channels)
    : stride_((1 + channels + kPadding - 1) / kPadding * kPadding),
      data_(static_cast<std::size_t>(stride_) * kReservoirTexels, 0.0f) {}

void Reservoir::fill(const PaintLoad& load) {
  fill_rows(load, 0, kReservoirRows);
  as_loaded_ = true;
  surplus_ = 0;
}

void Reservoir::empty() {
  std::fill(data_.begin(), data_.end(), 0.0f);
  as_loaded_ = false;
}

void Reservoir::fill_rows(const PaintLoad& load, int begin, int end) {
  PENTIMENTO_CHECK(static_cast<int>(load.paint.size()) == stride_);
  for (int r = begin; r < end; ++r) {
    for (int c = 0; c < kReservoirColumns; ++c)
      std::copy_n(load.row(r), stride_,
                  data_.data() + static_cast<std::ptrdiff_t>(r * kReservoirColumns + c) * stride_);
  }
}

void Reservoir::sample(float u, float v, float* out) const {
  const float x = std::clamp((u + 0.5f) * kReservoirColumns - 0.5f, 0.0f, kReservoirColumns - 1.0f);
  const float y = std::clamp((v + 0.5f) * kReservoirRows - 0.5f, 0.0f, kReservoirRows - 1.0f);
  const int i = std::min(static_cast<int>(x), kReservoirColumns - 2);
  const int j = std::min(static_cast<int>(y), kReservoirRows - 2);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const float* a = texel(j * kReservoirColumns + i);
  const float* c = a + static_cast<std::ptrdiff_t>(kReservoirColumns) * stride_;
  blend_texels(a, a + stride_, c, c + stride_,
               {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}, stride_, out);
}

void Reservoir::refill(const PaintLoad& load, const Tip& tip, float refill_frac) {
  surplus_ = 0;
  if (as_loaded_) return;
  content_.resize(tip.texels().size());
  const bool gives = load.content_m > 0 && refill_frac != 0;
  for (std::size_t n = 0; n < content_.size(); ++n) {
    const TipTexel& t = tip.texels()[n];
    float* paint = data_.data() + static_cast<std::ptrdiff_t>(t.index) * stride_;
    const float content = load.content_of(paint);
    content_[n] = content;
    surplus_ += static_cast<double>(t.weight * std::max(0.0f, content - load.content_m));
    if (!gives) continue;
    const float scale = refill_frac * std::max(1.0f, content / load.content_m);
    const float* wanted = load.row(t.index / kReservoirColumns);
    for (int k = 0; k < stride_; k += 4) {
      for (int i = k; i < k + 4; ++i) {
        const float mixed = paint[i] + (wanted[i] * scale - refill_frac * paint[i]);
        paint[i] = mixed < kTrace ? 0 : mixed;
      }
    }
  }
}

void Reservoir::drop_surplus(const PaintLoad& load, const Tip& tip, float frac) {
  if (!(surplus_ > 0)) return;
  for (std::size_t n = 0; n < content_.size(); ++n) {
    const TipTexel& t = tip.texels()[n];
    const float content = content_[n];
    if (!(content > load.content_m)) continue;
    const float share = std::min(1.0f, frac * t.weight) * (content - load.content_m) / content;
    float* paint = data_.data() + static_cast<std::ptrdiff_t>(t.index) * stride_;
    for (int k = 0; k < stride_; k += 4)
      for (int i = k; i < k + 4; ++i) paint[i] -= share * paint[i];
    content_[n] = content - share * content;
  }
}

}  // namespace pentimento

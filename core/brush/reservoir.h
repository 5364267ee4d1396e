#pragma once
// What a brush holds: a texture of paint over the tip (R21, R22, R24), so that a stroke streaks.
// Paint is a height of medium and an amount per channel, both per area of tip; its `content` counts
// pigment as a height too, so that paint of any thinness can be measured against a full load.
// The palette supplies it without end: laying a film does not empty it, lifted paint adds to it.

#include <array>
#include <span>
#include <vector>

#include "core/brush/tip.h"

namespace pentimento {

/// What the brush is dipped into (U of R22), as the reservoir holds it.
struct PaintLoad {
  std::vector<float> paint;   // height (m), then amounts per channel
  std::vector<float> amount;  // per channel: its share in the total amount (A26)
  float height_per_amount_m = 0.05f;
  float content_m = 0;  // of `paint`

  /// Height plus amount as height.
  float content_of(const float* paint_at) const {
    float sum = 0;
    for (std::size_t c = 0; c < amount.size(); ++c)
      if (amount[c] != 0) sum += amount[c] * paint_at[1 + c];
    return paint_at[0] + height_per_amount_m * sum;
  }
};

/// out = w[0] a + w[1] b + w[2] c + w[3] d over `stride` floats, a whole number of fours.
inline void blend_texels(const float* a, const float* b, const float* c, const float* d,
                         const std::array<float, 4>& w, int stride, float* out) {
  for (int k = 0; k < stride; k += 4)
    for (int i = k; i < k + 4; ++i) out[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
}

class Reservoir {
 public:
  explicit Reservoir(int channels);

  /// Every texel becomes the load.
  void fill(const PaintLoad& load);
  /// Floats per texel: height, channels, padding of zeros.
  int stride() const { return stride_; }
  float* texel(int index) { return data_.data() + static_cast<std::ptrdiff_t>(index) * stride_; }
  const float* texel(int index) const {
    return data_.data() + static_cast<std::ptrdiff_t>(index) * stride_;
  }
  /// Bilinear paint at (u, v) in tip coordinates, clamped at the edge; `out` has stride() floats.
  void sample(float u, float v, float* out) const;

  /// R22: each of the tip's texels goes the share `refill_frac` of the way to the load's paint, at
  /// its own content if that is larger (the palette takes and gives alike).
  void refill(const PaintLoad& load, const Tip& tip, float refill_frac);
  /// What is above the load's content, summed over texels with their weights.
  double weighted_surplus(const PaintLoad& load, const Tip& tip) const;
  /// Takes the share `frac` x weight of each texel's surplus away, its composition kept.
  void drop_surplus(const PaintLoad& load, const Tip& tip, float frac);

  float density_frac = 1;    // R24: fluid left, 1 at touch-down
  float dry_ahead_frac = 1;  // share of dry canvas in what the stroke ran onto last

 private:
  int stride_;
  std::vector<float> data_;
};

}  // namespace pentimento

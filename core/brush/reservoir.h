#pragma once
// What a brush holds: a texture of paint over the tip (R21, R22, R24), so that a stroke streaks.
// Paint is a height of medium and an amount per channel, both per area of tip; its `volume` counts
// pigment as a height too, so that paint of any thinness can be measured against a full load.
// The palette supplies it without end: laying a film does not empty it, lifted paint adds to it.

#include <array>
#include <span>
#include <vector>

#include "core/brush/paint_load.h"
#include "core/brush/tip.h"
#include "core/brush/tip_pose.h"

namespace pentimento {

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
  /// Nothing is in it.
  void empty();
  /// Only the texels whose row is in [begin, end) do.
  void fill_rows(const PaintLoad& load, int begin, int end);
  /// Floats per texel: height, channels, padding of zeros.
  int stride() const { return stride_; }
  const float* texel(int index) const {
    return data_.data() + static_cast<std::ptrdiff_t>(index) * stride_;
  }
  /// For writing: the brush no longer holds just what it was loaded with.
  float* dirty_texel(int index) {
    as_loaded_ = false;
    return data_.data() + static_cast<std::ptrdiff_t>(index) * stride_;
  }
  /// Bilinear paint at (u, v) in tip coordinates, clamped at the edge; `out` has stride() floats.
  void sample(float u, float v, float* out) const;
  /// The same, to the bit, at the cells [first, first + n) of a row: `out` has n times stride()
  /// floats.
  void sample_row(const TipRow& tip, int first, int n, float* out) const;

  /// R22: each of the tip's texels goes the share `refill_frac` of the way to the load's paint, at
  /// its own volume if that is larger (the palette takes and gives alike). Measures the surplus.
  void refill(const PaintLoad& load, const Tip& tip, float refill_frac);
  /// What was above the load's volume at the last refill(), summed over texels with their weights.
  double weighted_surplus() const { return surplus_; }
  /// Takes the share `frac` x weight of the surplus measured last from each texel, its composition
  /// kept.
  void drop_surplus(const PaintLoad& load, const Tip& tip, float frac);

  float density_frac = 1;    // R24: fluid left, 1 when full
  float dry_ahead_frac = 1;  // share of dry canvas in what the stroke ran onto last

 private:
  int stride_;
  bool as_loaded_ = false;  // nothing but fill() has touched it: a refill would change nothing
  double surplus_ = 0;
  std::vector<float> data_;
  std::vector<float> volume_;  // of the tip's texels, in their order, since the last refill
};

}  // namespace pentimento

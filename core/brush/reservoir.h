#pragma once
// The reservoir: what a brush holds, as a texture of paint over the tip (R21, R22, R24), so that a
// stroke has streaks. Paint is a height of medium and an amount of each channel, both per area of
// tip. Its `volume` counts pigment as a height too, so that paint of any thinness can be measured
// against a full load.
// The palette supplies the reservoir without end: depositing a film does not empty it, and picked
// up paint adds to it.

#include <array>
#include <span>
#include <vector>

#include "core/brush/paint_load.h"
#include "core/brush/tip.h"
#include "core/brush/tip_pose.h"

namespace pentimento {

/// out = w[0] a + w[1] b + w[2] c + w[3] d for `stride` floats. `stride` is a multiple of 4.
inline void blend_texels(const float* a, const float* b, const float* c, const float* d,
                         const std::array<float, 4>& w, int stride, float* out) {
  for (int k = 0; k < stride; k += 4)
    for (int i = k; i < k + 4; ++i) out[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
}

/// Cells of a row that are sampled together.
inline constexpr int kSampledCells = 64;

class Reservoir {
 public:
  explicit Reservoir(int channels);

  /// Fills every texel with the load.
  void fill(const PaintLoad& load);
  /// Takes everything out.
  void empty();
  /// Fills only the texels in the rows [begin, end) with the load.
  void fill_rows(const PaintLoad& load, int begin, int end);
  /// Floats per texel: height, channels, padding of zeros.
  int stride() const { return stride_; }
  const float* texel(int index) const {
    return data_.data() + static_cast<std::ptrdiff_t>(index) * stride_;
  }
  /// A texel for writing. From then on the brush no longer counts as holding just its load.
  float* dirty_texel(int index) {
    as_loaded_ = false;
    return data_.data() + static_cast<std::ptrdiff_t>(index) * stride_;
  }
  /// The paint at (u, v) in tip coordinates, bilinear between texels and clamped at the edge. `out`
  /// has stride() floats.
  void sample(float u, float v, float* out) const;
  /// The same bits as sample(), for the cells [first, first + n) of a row. `out` has n times
  /// stride() floats.
  void sample_row(const TipRow& tip, int first, int n, float* out) const;
  /// The same bits again, each component by itself: component k of cell i becomes
  /// out[k * kSampledCells + i]. `n` is a multiple of four, at most kSampledCells.
  void sample_planes(const TipRow& tip, int first, int n, float* out) const;

  /// R22: each of the tip's texels goes the share `refill_frac`, 0..1, of the way to the load's
  /// paint. A texel with more volume than the load keeps its volume: the palette takes as much as
  /// it gives. Measures the surplus.
  void refill(const PaintLoad& load, const Tip& tip, float refill_frac);
  /// The surplus at the last refill(): the volume above the load's, summed over the texels with
  /// their weights, m.
  double weighted_surplus() const { return surplus_; }
  /// Takes from each texel the share `frac` x weight of its surplus at the last refill(). The
  /// mixture of its paint stays.
  void drop_surplus(const PaintLoad& load, const Tip& tip, float frac);

  /// All that a reservoir keeps from one stamp to the next.
  struct Content {
    bool as_loaded = false;
    float density_frac = 1, dry_ahead_frac = 1;
    std::vector<float> texels;  // stride() floats each
  };
  Content content() const { return {as_loaded_, density_frac, dry_ahead_frac, data_}; }
  /// Holds what another reservoir of as many channels held.
  void restore(Content content);

  float density_frac = 1;    // R24: fluid left, 1 when full
  float dry_ahead_frac = 1;  // share of dry canvas where the stroke ran onto last

 private:
  template <int kStride>
  void refill_texels(const PaintLoad& load, const Tip& tip, float refill_frac, bool gives);

  int stride_;
  bool as_loaded_ = false;  // only fill() has changed it: a refill would do nothing
  double surplus_ = 0;
  std::vector<float> data_;
  std::vector<float> volume_;  // of the tip's texels, in their order, since the last refill
};

}  // namespace pentimento

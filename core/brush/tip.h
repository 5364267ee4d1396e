#pragma once
// A brush tip ready to be stamped: its map at many resolutions, so that a cell of any size gets the
// mean of the tip over about its own area. Immutable once made; safe to read from threads.

#include <algorithm>
#include <array>
#include <vector>

#include "core/brush/brush_settings.h"
#include "core/brush/paint_load.h"
#include "core/brush/tip_shapes.h"
#include "core/field.h"

namespace pentimento {

/// One resolution of a tip, with a rim of zeros so that it fades out beyond its edge.
class TipLevel {
 public:
  explicit TipLevel(const Field<float>& map);
  int size() const { return size_; }
  /// Bilinear value at (u, v) in tip diameters from the centre; 0 outside the tip.
  float at(float u, float v) const {
    const float x = (u + 0.5f) * static_cast<float>(size_) + 0.5f;
    const float y = (v + 0.5f) * static_cast<float>(size_) + 0.5f;
    const float end = static_cast<float>(size_ + 1);
    if (!(x >= 0 && y >= 0 && x < end && y < end)) return 0;
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
    const float* top = padded_.row(j) + i;
    const float* bottom = padded_.row(j + 1) + i;
    const float a = top[0] + fx * (top[1] - top[0]);
    const float b = bottom[0] + fx * (bottom[1] - bottom[0]);
    return a + fy * (b - a);
  }

 private:
  int size_;
  Field<float> padded_;
};

/// A texel of the reservoir that takes part: where, and how strongly the tip touches there.
struct TipTexel {
  int index = 0;       // row (v) times kReservoirColumns plus column (u)
  float u = 0, v = 0;  // its centre in tip coordinates
  float weight = 0;    // min(1, value / mean), the largest around: (0,1]
};

class Tip {
 public:
  /// Draws the brush's tip. The hairs are the name's: the same name, the same hairs.
  explicit Tip(const BrushDefinition& brush);

  /// The level whose texels are nearest in size to a cell of `cell_frac` tip diameters, > 0.
  const TipLevel& level_for(float cell_frac) const;
  /// Mean value over the tip's square, in [0,1].
  float mean() const { return mean_; }
  TipExtent extent() const { return extent_; }
  /// How strongly the hairs at v (tip coordinates) take hold: hair_grip(), interpolated.
  float grip(float v) const {
    const float x = std::clamp((v + 0.5f) * kGripSteps, 0.0f, kGripSteps - 0.001f);
    const std::size_t i = static_cast<std::size_t>(x);
    return grip_[i] + (x - static_cast<float>(i)) * (grip_[i + 1] - grip_[i]);
  }
  /// The reservoir's texels that the tip covers, and those that touch them.
  const std::vector<TipTexel>& texels() const { return texels_; }
  /// 1 for those, 0 for the others.
  float covered(int texel) const { return covered_[static_cast<std::size_t>(texel)]; }

 private:
  void list_texels(const Field<float>& map);

  std::vector<TipLevel> levels_;  // finest first, half an octave apart
  float mean_ = 0;
  TipExtent extent_;
  std::vector<TipTexel> texels_;
  std::array<float, kReservoirTexels> covered_{};
  static constexpr int kGripSteps = 128;
  std::array<float, kGripSteps + 1> grip_{};
};

}  // namespace pentimento

#pragma once
// A tip ready to be stamped. It has its map at many resolutions, so that a cell of any size gets
// the mean of the tip over about its own area. It has maps for several amounts of press and blends
// between them. Immutable once made; safe to read from several threads.

#include <algorithm>
#include <array>
#include <vector>

#include "core/base/field.h"
#include "core/brush/brush_settings.h"
#include "core/brush/paint_load.h"
#include "core/brush/tip_shapes.h"

namespace pentimento {

/// The map of a tip at one resolution, with a rim of zeros, so that the tip fades out beyond its
/// edge.
class TipMap {
 public:
  explicit TipMap(const Field<float>& map);
  int size() const { return size_; }
  /// Row j - 1 of the map with its rim: size() + 2 values. j in [0, size() + 1].
  const float* padded_row(int j) const { return padded_.row(j); }
  /// Bilinear value at (u, v), in tip diameters from the centre, of a map that lies the share
  /// `frac` of the way from `a` to `b`. Both have the same size. 0 outside the tip.
  static float between(const TipMap& a, const TipMap& b, float frac, float u, float v) {
    const float x = (u + 0.5f) * static_cast<float>(a.size_) + 0.5f;
    const float y = (v + 0.5f) * static_cast<float>(a.size_) + 0.5f;
    const float end = static_cast<float>(a.size_ + 1);
    if (!(x >= 0 && y >= 0 && x < end && y < end)) return 0;
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
    const float low = a.bilinear(i, j, fx, fy);
    return frac == 0 ? low : low + frac * (b.bilinear(i, j, fx, fy) - low);
  }

 private:
  float bilinear(int i, int j, float fx, float fy) const {
    const float* top = padded_.row(j) + i;
    const float* bottom = padded_.row(j + 1) + i;
    const float a = top[0] + fx * (top[1] - top[0]);
    const float b = bottom[0] + fx * (bottom[1] - bottom[0]);
    return a + fy * (b - a);
  }

  int size_;
  Field<float> padded_;
};

/// A table over v, for a quantity that differs across the stroke and not along it.
class BristleTable {
 public:
  float& operator[](int i) { return value_[static_cast<std::size_t>(i)]; }
  static constexpr int kSteps = 128;
  /// The v, in tip coordinates, that step i stands for.
  static float at_step(int i) { return static_cast<float>(i) / kSteps - 0.5f; }
  /// Value at v, linear between the steps.
  float at(float v) const {
    const float x = std::clamp((v + 0.5f) * kSteps, 0.0f, kSteps - 0.001f);
    const std::size_t i = static_cast<std::size_t>(x);
    return value_[i] + (x - static_cast<float>(i)) * (value_[i + 1] - value_[i]);
  }
  static constexpr int kMostInRow = 64;
  /// at(v0 + dv i) for i = first .. first + n - 1, n <= kMostInRow.
  void row(float v0, float dv, int first, int n, float* out) const;
  /// The mean of at() over [v - width / 2, v + width / 2] at each step, exact. `width` > 0, in
  /// diameters.
  BristleTable averaged(float width) const;

 private:
  std::array<float, kSteps + 1> value_{};
};

/// How a tip is held at a stamp.
struct TipState {
  float press = 1;         // how far the bristles are pressed down, 0..1
  float density_frac = 1;  // fluid left; below about 0.8 bristles run dry, one by one
};

/// A tip at one resolution in one state.
struct TipLevel {
  const TipMap* low = nullptr;
  const TipMap* high = nullptr;
  float frac = 0;                            // share of the way from low to high
  const BristleTable* supply_low = nullptr;  // nullptr: all bristles are wet
  const BristleTable* supply_high = nullptr;
  float supply_frac = 0;

  /// Value at (u, v) in tip diameters from the centre, in [0,1].
  float at(float u, float v) const {
    const float value = TipMap::between(*low, *high, frac, u, v);
    if (supply_low == nullptr || value == 0) return value;
    const float few = supply_low->at(v);
    return value * (few + supply_frac * (supply_high->at(v) - few));
  }
};

/// A texel of the reservoir that the tip uses: where it lies, and how strongly the tip touches
/// there.
struct TipTexel {
  int index = 0;       // row (v) times kReservoirColumns plus column (u)
  float u = 0, v = 0;  // its centre in tip coordinates
  float weight = 0;    // min(1, value / mean), the largest around: (0,1]
};

/// Which texels of the reservoir a tip covers, 1 or 0, as kernels read it.
struct CoveredTexels {
  std::array<float, kReservoirTexels> by_row{}, by_column{};

  void add(int column, int row) {
    const std::size_t at = static_cast<std::size_t>(row * kReservoirColumns + column);
    by_row[at] = 1;
    by_column[static_cast<std::size_t>(column * kReservoirRows + row)] = 1;
  }
};

class Tip {
 public:
  /// Draws the brush's tip. The bristles follow from the brush's name: the same name gives the same
  /// bristles.
  explicit Tip(const BrushDefinition& brush);

  /// The tip at the resolution whose texels are nearest in size to a cell of `cell_frac` tip
  /// diameters, > 0.
  TipLevel level_for(float cell_frac, const TipState& state = {}) const;
  /// Mean value over the tip's square, in [0,1], if all bristles are wet. `press` in [0,1].
  float mean(float press = 1) const;
  TipExtent extent() const { return extent_; }
  /// The grip at v in tip coordinates: bristle_grip(), interpolated.
  const BristleTable& grip_table() const { return grip_; }
  /// How far v lies under the ends of the tip, where a blade lets paint pass. 0 where the tip's
  /// value stays below 0.65, 1 where it reaches 0.85. It depends on v alone, so it does not change
  /// along the stroke.
  const BristleTable& end_table() const { return ends_; }
  /// Share of what stands above a blade's edge that is left once the blade is past: 1 under its
  /// ends, 1 - kScraped elsewhere.
  const BristleTable& kept_table() const { return kept_; }
  /// Whether the tip reaches the canvas at v somewhere along its length: 0 where its value is 0
  /// there, 1 where it reaches a quarter.
  const BristleTable& reach_table() const { return reach_; }
  /// The reservoir's texels that the tip covers, and the texels next to those.
  const std::vector<TipTexel>& texels() const { return texels_; }
  /// The same texels.
  const CoveredTexels& covered() const { return covered_; }

 private:
  /// The maps of one amount of press: the finest first, half an octave apart.
  struct Press {
    std::vector<TipMap> maps;
    float mean = 0;
  };
  void add_press(const Field<float>& master);
  void find_extent(const Field<float>& widest);
  void list_texels(const Field<float>& map);
  void fill_tables(const BrushDefinition& brush, std::uint64_t seed);
  void fill_ends(const Field<float>& widest);

  std::vector<Press> presses_;  // evenly from press 0 to 1; a single one stands for all
  TipExtent extent_;
  std::vector<TipTexel> texels_;
  CoveredTexels covered_;
  BristleTable grip_, ends_, kept_, reach_;
  std::vector<BristleTable> supply_;  // evenly from dry to kWetFrac; empty: no bristles
};

}  // namespace pentimento

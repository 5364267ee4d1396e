#pragma once
// A field of the guide as a smooth surface over the fine cells of a tile.

#include <array>
#include <functional>
#include <vector>

#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// Weights that the cubic B-spline gives four cells in a row at a point `t` cells behind the centre
/// of the second, 0 <= t <= 1.
constexpr std::array<float, 4> spline_weights(float t) {
  const float r = 1 - t;
  return {r * r * r / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * r * r + 3 * r * r * r) / 6,
          t * t * t / 6};
}

/// Which four cells in a row a point leans on: the first, counted from its own cell, and weights.
struct SplineTaps {
  int first;
  std::array<float, 4> weight;
};

/// Of a point `from_centre` cells behind the centre of its cell, |from_centre| <= 1/2.
constexpr SplineTaps spline_taps(float from_centre) {
  if (from_centre < 0) return {-2, spline_weights(from_centre + 1)};
  return {-1, spline_weights(from_centre)};
}

/// Values of guide cells in and around a tile, two cells more on each side, which the surface is
/// made from.
class TileNeighbourhood {
 public:
  static constexpr int kMargin = 2;
  /// Cells beyond the canvas repeat its outermost.
  TileNeighbourhood(const CellBox& box, int guide_width, int guide_height);
  /// Sets every value to value_at(x, y) of the guide.
  void fill(const std::function<float(int, int)>& value_at);
  /// Of the guide cell (x, y), at most kMargin outside the box.
  float at(int x, int y) const {
    return value_[static_cast<std::size_t>((y - y0_) * width_ + x - x0_)];
  }

  /// The cubic B-spline with the values as coefficients, at the centres of the tile's fine cells:
  ///   s(x, y) = sum_ij B(x - i) B(y - j) v_ij, B the cubic B-spline with knots one cell apart
  /// Scheme: smooths (variance 1/3 cell^2), second derivatives continuous, within the values'
  /// range. Stable: weights are >= 0 and sum to 1. Source: Unser, IEEE Signal Processing Mag. 16
  /// (1999) 22-38. Departs from it: no prefilter, which would overshoot.
  /// `out` has box.width() k values in each of box.height() k rows, `stride` apart.
  void smooth(int factor, float* out, std::ptrdiff_t stride) const;

 private:
  CellBox box_;
  int guide_width_, guide_height_;
  int x0_, y0_, width_, height_;
  std::vector<float> value_;
};

}  // namespace pentimento

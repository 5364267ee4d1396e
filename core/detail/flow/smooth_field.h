#pragma once
// A plane of the guide as a smooth surface over the fine cells of a tile.

#include <array>
#include <functional>
#include <vector>

#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// Weights of four cells in a row, by the cubic B-spline, at a point `t` cells after the centre of
/// the second cell. 0 <= t <= 1.
constexpr std::array<float, 4> spline_weights(float t) {
  const float r = 1 - t;
  return {r * r * r / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * r * r + 3 * r * r * r) / 6,
          t * t * t / 6};
}

/// The four cells in a row that give the value at a point: the first of them, counted from the
/// point's own cell, and their weights.
struct SplineTaps {
  int first;
  std::array<float, 4> weight;
};

/// Taps of a point `from_centre` cells after the centre of its cell, |from_centre| <= 1/2.
constexpr SplineTaps spline_taps(float from_centre) {
  if (from_centre < 0) return {-2, spline_weights(from_centre + 1)};
  return {-1, spline_weights(from_centre)};
}

/// Values of the guide's cells in a tile and two cells around it. The surface is made from them.
class TileNeighbourhood {
 public:
  static constexpr int kMargin = 2;
  /// `box`: the cells of the tile. Cells beyond the canvas repeat the outermost cells.
  TileNeighbourhood(const CellBox& box, int guide_width, int guide_height);
  /// Sets every value to value_at(x, y) of the guide.
  void fill(const std::function<float(int, int)>& value_at);
  /// Value of the guide's cell (x, y), which lies at most kMargin outside the box.
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

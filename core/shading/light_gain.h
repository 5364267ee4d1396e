#pragma once
// The factor on a picture's light as a smooth surface over cells: rows of it, and what a row of
// cells means of the light under it. Pure functions.

#include <array>
#include <span>
#include <vector>

#include "core/shading/tile_plan.h"

namespace pentimento {

/// One axis of a picture whose pixels are no larger than the cells of a coarser grid; both cover
/// the canvas from edge to edge. A pixel belongs to the cell in which its centre lies.
struct GainAxis {
  int cells = 1;
  int pixels = 1;
  int cell_of(int pixel) const;
  /// The first pixel that belongs to a cell; `pixels` for cell = cells.
  int first_pixel(int cell) const;
};

/// A run of cells along an axis, and the pixels that belong to them.
struct GainLine {
  GainLine(const GainAxis& axis, PixelRun cell_run);
  PixelRun pixel_run;
  std::vector<int>
      begin;  // of each cell's pixels, counted from the run's first; one more at the end
  /// Per pixel: shares of the cell before its own, of its own, and of the one after. Quadratic
  /// B-spline, knots at the cells' borders.
  std::vector<std::array<float, 3>> weight;
  int cells() const { return static_cast<int>(begin.size()) - 1; }
};

/// Gains of one colour in three rows of cells: above, of the row, below.
using GainRows = std::array<const float*, 3>;

/// Factor on each pixel of cell i of a row of pixels:
///   G = sum_m wx_m sum_n wy_n g_(i+m-1),n   (cells beyond the ends repeat the outermost)
/// Scheme: quadratic B-spline of the gains, continuous with its slope. Stable: within the gains'
/// range. Source: de Boor 1978. Departs from it: no prefilter.
void gain_pixels(const GainLine& across, int i, const std::array<float, 3>& down,
                 const GainRows& gain, float* out);

/// What the light under a gain depends on, cell by cell of a row:
///   M_nm = sum over the cell's pixels of P wy_n wx_m,  sum of P G = sum_nm M_nm g_(i+m-1),n
/// It is found once for all gains. Scheme: sums in float, the rows of a column first. Stable: sums
/// of light >= 0. Source: the order of summation in gain_pixels(), exchanged.
constexpr int kGainMoments = 9;  // 3 n + m

/// The moments of the cells [first, last). `light`: rows of pixels of one colour, each the whole
/// run of `across`, with their weights `down`. `moment`: kGainMoments rows of across.cells().
void find_gain_moments(const GainLine& across, int first, int last,
                       std::span<const float* const> light, const std::array<float, 3>* down,
                       float* moment);

/// The sum of P G over the pixels of each cell of a row, from its moments.
void sum_under_gain(const float* moment, int cells, const GainRows& gain, float* sum);

/// What a cell's light is raised by, from what it should be (`wanted`) and what it is (`found`):
///   (wanted + f) / (found + f),  f = 0.002: light below a five-hundredth of white is not told
///   apart
/// limited to [1/2, 2]. Both >= 0.
float light_ratio(float wanted, float found);

}  // namespace pentimento

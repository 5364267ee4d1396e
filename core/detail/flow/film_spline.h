#pragma once
// The guide's film in and around a box, as coefficients of two smooth surfaces (smooth_field.h):
// the coverage, which says how far the film reaches, and the depth of the film.

#include <cstddef>
#include <vector>

#include "core/base/field.h"
#include "core/detail/flow/smooth_field.h"
#include "core/detail/store/detail_layout.h"

namespace pentimento {

/// For a plane d of the guide (depth or a pigment), per cell:
///   f: d / the largest d around, where one of the four cells beside it is bare; else 1, or 0 if
///      d = 0; then twice, where it is below 1, f <- f sqrt(d B(f) / (M B(d))), each factor in
///      [1/2, 2], f at most 1; then evened along the film's edges (even_edges.h); then twice, where
///      one of the 3 x 3 cells around is bare of film, M is below 1/4 and f below 0.8,
///      f <- f sqrt(1 / (4 M)), each factor at most 2, f at most 1;
///   c: three times c <- c d / (M B(c) / B(f)), from c = d, each factor in [1/2, 2], c in
///      [d/4, 4d];
///      M: mean over the cell of the edge's profile m(W) (level_rows.h), W the spline of f;
///      B: mean over the cell of the spline, (1, 76, 230, 76, 1) / 384 along each axis
/// so that the film m(W) S, S the spline of c over W, holds about what the guide's cells hold: a
/// spline of d itself flattens whatever is one cell wide, and the lock would bring it back cell by
/// cell, as beads. The contour comes as far into the corner cells of a staircase as their paint
/// needs: else the lock would heap that paint up in the corners, as spikes. Where an edge slants
/// less than that, its steps are longer than the spline is wide; evened, it is a line that stands
/// back by what the first cells of a step have no paint for.
/// Scheme: multiplicative deconvolution (Richardson, J. Opt. Soc. Am. 62 (1972) 55-59; Lucy 1974),
/// without the second blur. Stable: positive, bounded. Departs from it: M is taken out of the mean
/// of the product. Depends on d within 27 cells, and for a pigment on the depth there, and on
/// nothing else: neighbouring boxes agree where they meet.
class FilmSpline {
 public:
  static constexpr int kMargin = TileNeighbourhood::kMargin;  // cells with coefficients around it
  /// Of the depth.
  FilmSpline(const Field<float>& depth_m, const CellBox& box);
  /// Of a pigment in the film. Its own edges inside the film stay as they were fitted.
  FilmSpline(const Field<float>& pigment, const FilmSpline& film);
  /// f and c of a cell of the guide, at most kMargin outside the box. Cells beyond the canvas
  /// repeat the outermost cells.
  float coverage(int x, int y) const { return coverage_[at(x, y)]; }
  float film(int x, int y) const { return film_[at(x, y)]; }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>((y - y0_) * width_ + x - x0_);
  }
  template <typename Holds>
  std::vector<std::size_t> cells_where(int margin, const Holds& holds) const;
  std::vector<float> profile_means(const std::vector<std::size_t>& cells) const;
  void fill_coverage(const std::vector<float>& held, int canvas_width, int canvas_height);
  void fit_contour(const std::vector<float>& held, const std::vector<float>& film);
  void fit_coverage(const std::vector<float>& held, const std::vector<float>& mean, int margin);
  void fit(const Field<float>& plane, const std::vector<float>& held,
           const std::vector<float>& film);
  std::vector<float> read(const Field<float>& plane) const;
  bool bare_beside(const std::vector<float>& film, std::size_t cell) const;
  void widen(const std::vector<float>& held, const std::vector<float>& film, int margin);
  void sharpen(const std::vector<float>& held, const std::vector<float>& profile,
               const std::vector<float>& spread, int margin);

  int x0_, y0_, width_, height_;
  std::vector<float> held_;  // of the depth; a pigment keeps none
  std::vector<float> coverage_, film_;
};

}  // namespace pentimento

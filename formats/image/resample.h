#pragma once
// Resampling of planes that reach the state (paper relief, tips, loaded pictures, reflectance):
// only + - * / and comparisons in a fixed order, so the result is the same bits everywhere. Pixel
// centres lie at half integers; a plane covers the unit square whatever its size.

#include <memory>
#include <span>

#include "core/base/field.h"

namespace pentimento {

/// Mean over each target pixel's area; exact for any ratio >= 1, and for a smaller source it
/// repeats pixels. The sum over the plane times the pixel area is kept (to rounding).
Field<float> resample_area(FieldView<const float> source, int width, int height);

/// Bilinear between pixel centres, edge pixels continued outwards.
Field<float> resample_bilinear(FieldView<const float> source, int width, int height);

/// Catmull-Rom cubic between pixel centres, edge pixels continued outwards. Overshoots at edges.
Field<float> resample_bicubic(FieldView<const float> source, int width, int height);

/// What fits a picture to a size: per axis area means where it shrinks, bilinear where it grows.
Field<float> resample_to(FieldView<const float> source, int width, int height);

/// A seamless texture laid as tiles from the origin: value at the centre of each cell of a grid of
/// `width` x `height` cells, of which `cells_per_repeat_x` x `cells_per_repeat_y` (> 0, not
/// necessarily whole) lie on one tile. Bilinear with wrap-around where the tile is magnified, mean
/// over the cell where it is reduced.
Field<float> sample_repeated(FieldView<const float> tile, int width, int height,
                             double cells_per_repeat_x, double cells_per_repeat_y);

/// The same row by row, for grids that are never held whole: a picture fitted to a grid as
/// resample_to does, or laid as tiles as sample_repeated does, in the same bits.
class PictureRows {
 public:
  static PictureRows fitted(Field<float> picture, int width, int height);
  static PictureRows tiled(Field<float> tile, int width, int height, double cells_per_repeat_x,
                           double cells_per_repeat_y);
  /// Values of the cells [x, x + out.size()) of row y of the grid. From any thread.
  void row(int x, int y, std::span<float> out) const;

 private:
  struct Plan;
  explicit PictureRows(std::shared_ptr<const Plan> plan) : plan_(std::move(plan)) {}
  std::shared_ptr<const Plan> plan_;
};

}  // namespace pentimento

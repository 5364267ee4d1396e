#pragma once
// Resampling of planes that reach the state (paper relief, tips, loaded pictures, reflectance):
// only + - * / and comparisons in a fixed order, so the result is the same bits everywhere. Pixel
// centres lie at half integers; a plane covers the unit square whatever its size.

#include <memory>
#include <span>

#include "core/base/field.h"

namespace pentimento {

/// Each target pixel is the mean over its area. This is exact for any reduction; where the source
/// is smaller, pixels repeat. The sum over the plane times the area of a pixel stays, to rounding.
Field<float> resample_area(FieldView<const float> source, int width, int height);

/// Bilinear between pixel centres, edge pixels continued outwards.
Field<float> resample_bilinear(FieldView<const float> source, int width, int height);

/// Catmull-Rom cubic between pixel centres, edge pixels continued outwards. Overshoots at edges.
Field<float> resample_bicubic(FieldView<const float> source, int width, int height);

/// Fits a picture to a size: along each axis by area means where it shrinks, bilinear where it
/// grows.
Field<float> resample_to(FieldView<const float> source, int width, int height);

/// Repeats a seamless texture from the origin on, over a grid of `width` x `height` cells. One
/// repeat has `cells_per_repeat_x` x `cells_per_repeat_y` cells, both > 0 and not necessarily
/// whole. A cell takes the value at its centre, bilinear with wrap-around, where the texture is
/// magnified, and the mean over the cell where it is reduced.
Field<float> sample_repeated(FieldView<const float> tile, int width, int height,
                             double cells_per_repeat_x, double cells_per_repeat_y);

/// The same row by row, for grids that are never held whole: a picture fitted to a grid as
/// resample_to() does, or repeated as sample_repeated() does. The bits are the same.
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

#pragma once
// Departure points: where the paint that is now in a cell came from, and what the planes held
// there.

#include <algorithm>
#include <cstddef>

#include "core/base/field.h"

namespace pentimento::paper {

/// A point between cell centres: in the square of cells x0, x1 by y0, y1, at the fractions fx, fy.
/// The offsets of the four cells hold for every plane of the canvas, since all share one stride.
struct Departure {
  int x0, x1, y0, y1;
  float fx, fy;
  std::ptrdiff_t top_left, top_right, bottom_left, bottom_right;
};

/// Size of a plane and the distance of its rows, in elements.
struct GridShape {
  int width, height;
  std::ptrdiff_t stride;
};

inline GridShape shape_of(const Field<float>& f) {
  return {f.width(), f.height(), f.view().stride()};
}

/// The point (x, y) - (cells_x, cells_y), clamped to the canvas: nothing comes from outside (R8).
inline Departure depart(int x, int y, float cells_x, float cells_y, const GridShape& grid) {
  const float last_x = static_cast<float>(grid.width - 1);
  const float last_y = static_cast<float>(grid.height - 1);
  const float px = std::min(std::max(static_cast<float>(x) - cells_x, 0.0f), last_x);
  const float py = std::min(std::max(static_cast<float>(y) - cells_y, 0.0f), last_y);
  const int x0 = static_cast<int>(px), y0 = static_cast<int>(py);
  const int x1 = std::min(x0 + 1, grid.width - 1), y1 = std::min(y0 + 1, grid.height - 1);
  const std::ptrdiff_t top = y0 * grid.stride, bottom = y1 * grid.stride;
  return {x0,
          x1,
          y0,
          y1,
          px - static_cast<float>(x0),
          py - static_cast<float>(y0),
          top + x0,
          top + x1,
          bottom + x0,
          bottom + x1};
}

inline float mix(float a, float b, float t) {
  return a + t * (b - a);
}

/// The value of a plane at the point, bilinear. A constant plane gives its constant exactly; a
/// plane without negative values gives none. `plane` points to the first cell of the plane.
inline float interpolate(const float* plane, const Departure& p) {
  return mix(mix(plane[p.top_left], plane[p.top_right], p.fx),
             mix(plane[p.bottom_left], plane[p.bottom_right], p.fx), p.fy);
}

/// The same for the product of two planes.
inline float interpolate_product(const float* f, const float* g, const Departure& p) {
  return mix(mix(f[p.top_left] * g[p.top_left], f[p.top_right] * g[p.top_right], p.fx),
             mix(f[p.bottom_left] * g[p.bottom_left], f[p.bottom_right] * g[p.bottom_right], p.fx),
             p.fy);
}

}  // namespace pentimento::paper

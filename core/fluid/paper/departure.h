#pragma once
// Where the paint that is now in a cell came from, and what was there.

#include <algorithm>

#include "core/field.h"

namespace pentimento::paper {

/// A point between cell centres: in the square of cells x0, x1 by y0, y1, at the fractions fx, fy.
struct Departure {
  int x0, x1, y0, y1;
  float fx, fy;
};

/// The point (x, y) - (cells_x, cells_y), clamped to the canvas: nothing comes from outside (R8).
inline Departure depart(int x, int y, float cells_x, float cells_y, int width, int height) {
  const float last_x = static_cast<float>(width - 1), last_y = static_cast<float>(height - 1);
  const float px = std::min(std::max(static_cast<float>(x) - cells_x, 0.0f), last_x);
  const float py = std::min(std::max(static_cast<float>(y) - cells_y, 0.0f), last_y);
  const int x0 = static_cast<int>(px), y0 = static_cast<int>(py);
  return {x0,
          std::min(x0 + 1, width - 1),
          y0,
          std::min(y0 + 1, height - 1),
          px - static_cast<float>(x0),
          py - static_cast<float>(y0)};
}

inline float mix(float a, float b, float t) {
  return a + t * (b - a);
}

/// Bilinear; a constant plane gives its constant exactly, a non-negative one nothing negative.
inline float interpolate(const Field<float>& f, const Departure& p) {
  const float* a = f.row(p.y0);
  const float* b = f.row(p.y1);
  return mix(mix(a[p.x0], a[p.x1], p.fx), mix(b[p.x0], b[p.x1], p.fx), p.fy);
}

}  // namespace pentimento::paper

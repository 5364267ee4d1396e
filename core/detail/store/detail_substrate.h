#pragma once
// The substrate at the resolution of the detail canvas: the relief of the fresh paper and the
// reflectance of the ground. It is asked for tile by tile, so that nobody holds all of it.

#include <span>

namespace pentimento {

class DetailSubstrate {
 public:
  virtual ~DetailSubstrate() = default;
  /// Height in metres, >= 0, of the fine cells [x, x + out.size()) of row y. From any thread.
  virtual void relief_row(int x, int y, std::span<float> out) const = 0;
  /// Linear reflectance in [0,1] of one band of the same cells. From any thread.
  virtual void reflectance_row(int band, int x, int y, std::span<float> out) const = 0;
};

}  // namespace pentimento

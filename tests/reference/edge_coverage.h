#pragma once
// The twin of core/optics/edge_coverage.h: the share of one cell that wet paint covers (A40), by
// its definition, in double precision.

#include <algorithm>
#include <cmath>

#include "core/canvas/canvas_state.h"

namespace pentimento::reference {

class EdgeCoverage {
 public:
  explicit EdgeCoverage(const CanvasState& state) : s_(state) {}

  double operator()(int x, int y) const {
    if (depth(x, y) < kBare_m || inner(x, y)) return 1;
    double sum = 0, count = 0, deepest = 0;
    for (int v = y - 1; v <= y + 1; ++v) {
      for (int u = x - 1; u <= x + 1; ++u) {
        deepest = std::max(deepest, depth(u, v));
        if (!inner(u, v)) continue;
        sum += depth(u, v);
        ++count;
      }
    }
    const double share = depth(x, y) / (count > 0 ? sum / count : deepest);
    return share < kRise / 2 ? std::sqrt(2 * kRise * share) : std::min(share + kRise / 2, 1.0);
  }

 private:
  static constexpr double kBare_m = 1e-6, kRise = 0.75;

  double depth(int x, int y) const {
    return static_cast<double>(s_.depth_m(std::clamp(x, 0, s_.geometry.width - 1),
                                          std::clamp(y, 0, s_.geometry.height - 1)));
  }
  /// Paint, and paint in all eight neighbours.
  bool inner(int x, int y) const {
    for (int v = y - 1; v <= y + 1; ++v)
      for (int u = x - 1; u <= x + 1; ++u)
        if (depth(u, v) < kBare_m) return false;
    return true;
  }

  const CanvasState& s_;
};

}  // namespace pentimento::reference

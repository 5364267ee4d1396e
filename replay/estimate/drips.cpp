#include "replay/estimate/drips.h"

#include <algorithm>
#include <cmath>

namespace pentimento {

namespace {

constexpr double kGravity_m_s2 = 9.81;
constexpr double kSpeed_m_s = 0.016;
constexpr double kSheetHeights = 0.85, kDripHeights = 3;
constexpr double kDripSpacing_m = 0.018, kDripWidth_m = 0.004;

/// A line of cells down the slope.
struct Slope {
  double dx, dy;  // a cell further down
  int x(int from, int steps) const { return from + static_cast<int>(std::lround(dx * steps)); }
  int y(int from, int steps) const { return from + static_cast<int>(std::lround(dy * steps)); }
};

}  // namespace

void TiltedTime::pass(double time_s) {
  sum_x_s_ += x_ * (time_s - since_s_);
  sum_y_s_ += y_ * (time_s - since_s_);
  since_s_ = time_s;
}

void TiltedTime::tilt(double x_m_s2, double y_m_s2, double time_s) {
  pass(time_s);
  x_ = x_m_s2 / kGravity_m_s2;
  y_ = y_m_s2 / kGravity_m_s2;
}

void for_drips(const CanvasGeometry& grid, const CellBox& among, const TiltedTime& tilted,
               const std::function<bool(int x, int y)>& thin,
               const std::function<void(int from_x, int from_y, int x, int y)>& reach) {
  const double seconds = std::hypot(tilted.x_s(), tilted.y_s());
  const int farthest = static_cast<int>(std::lround(seconds * kSpeed_m_s / grid.dx_m()));
  if (farthest < 1) return;
  const Slope slope = {tilted.x_s() / seconds, tilted.y_s() / seconds};
  const auto inside = [&](int x, int y) {
    return x >= 0 && x < grid.width && y >= 0 && y < grid.height;
  };
  const auto is_thin = [&](int x, int y) { return inside(x, y) && thin(x, y); };
  for (int y = among.y0; y < among.y1; ++y)
    for (int x = among.x0; x < among.x1; ++x) {
      if (!is_thin(x, y) || is_thin(slope.x(x, 1), slope.y(y, 1))) continue;
      int height = 1;
      while (is_thin(slope.x(x, -height), slope.y(y, -height))) ++height;
      const double across_m = std::abs(x * slope.dy - y * slope.dx) * grid.dx_m();
      const bool drips = std::fmod(across_m, kDripSpacing_m) < kDripWidth_m;
      const double heights = drips ? kDripHeights : kSheetHeights;
      const int down = std::min(farthest, static_cast<int>(heights * height));
      for (int i = 1; i <= down && inside(slope.x(x, i), slope.y(y, i)); ++i)
        reach(x, y, slope.x(x, i), slope.y(y, i));
    }
}

}  // namespace pentimento

#pragma once
// The horizon search's slow twin: per cell, in double precision, straight from its definition.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/canvas/canvas_state.h"
#include "core/optics/lighting.h"
#include "core/shading/horizon.h"

namespace pentimento::reference {

class HorizonReference {
 public:
  using Rgb = std::array<double, 3>;
  HorizonReference(const CanvasState& state, const Lighting& lighting)
      : s_(state),
        strength_(lighting.occlusion),
        scale_(lighting.relief_scale),
        dx_(static_cast<double>(state.geometry.dx_m())),
        dy_(static_cast<double>(state.geometry.dy_m())),
        lines_(horizon_lines(state.geometry)) {}

  double sky_seen(double u, double v) const {
    if (strength_ == 0) return 1;
    return 1 + strength_ * (between(u, v, [&](int x, int y) { return sky(x, y); }) - 1);
  }

  /// `direction_at(x, y)`: towards the lamp from a cell.
  template <typename DirectionAt>
  double lamp_seen(double u, double v, const DirectionAt& direction_at) const {
    if (strength_ == 0) return 1;
    const double seen = between(u, v, [&](int x, int y) { return lamp(x, y, direction_at(x, y)); });
    return 1 + strength_ * (seen - 1);
  }

 private:
  double height(int x, int y) const {
    const int cx = std::clamp(x, 0, s_.geometry.width - 1);
    const int cy = std::clamp(y, 0, s_.geometry.height - 1);
    return scale_ * static_cast<double>(s_.base_m(cx, cy) + s_.depth_m(cx, cy));
  }

  template <typename At>
  static double between(double u, double v, const At& at) {
    const int x = static_cast<int>(std::floor(u)), y = static_cast<int>(std::floor(v));
    const double a = u - x, b = v - y;
    // Where a weight is 0 the cell is not looked at.
    const auto row = [&](int j) { return at(x, j) * (1 - a) + (a > 0 ? at(x + 1, j) * a : 0); };
    return row(y) * (1 - b) + (b > 0 ? row(y + 1) * b : 0);
  }

  double sky(int x, int y) const {
    const double right = (height(x + 1, y) - height(x - 1, y)) / (2 * dx_);
    const double down = (height(x, y + 1) - height(x, y - 1)) / (2 * dy_);
    const std::size_t steps = lines_.sky.size() / kSkyDirections;
    double seen = 0;
    for (std::size_t d = 0; d < kSkyDirections; ++d) {
      double rise = 0;
      for (std::size_t i = 0; i < steps; ++i) {
        const auto& to = lines_.sky[d * steps + i];
        const int i_x = static_cast<int>(to[0]), i_y = static_cast<int>(to[1]);
        const double run_x = i_x * dx_, run_y = i_y * dy_;
        const double above = height(x + i_x, y + i_y) - height(x, y) - right * run_x - down * run_y;
        rise = std::max(rise, above / std::sqrt(run_x * run_x + run_y * run_y));
      }
      const double angle = std::atan(rise);
      seen += std::cos(angle) * std::cos(angle) / kSkyDirections;
    }
    return seen;
  }

  double lamp(int x, int y, const Rgb& l) const {
    const double level = std::sqrt(l[0] * l[0] + l[1] * l[1]);
    if (l[2] <= 0 || level < 1e-3 * l[2]) return 1;
    double across = l[0] / dx_, down = -l[1] / dy_;
    const bool wide = std::abs(across) >= std::abs(down);
    const double longer = wide ? std::abs(across) : std::abs(down);
    across /= longer;
    down /= longer;
    double rise = 0;
    for (const float step : lines_.shadow) {
      const double at_x = across * static_cast<double>(step),
                   at_y = down * static_cast<double>(step);
      const int cx = static_cast<int>(wide ? std::lround(at_x) : std::floor(at_x));
      const int cy = static_cast<int>(wide ? std::floor(at_y) : std::lround(at_y));
      const double share = wide ? at_y - cy : at_x - cx;
      const double beside = wide ? height(x + cx, y + cy + 1) : height(x + cx + 1, y + cy);
      const double h = height(x + cx, y + cy) * (1 - share) + beside * share;
      const double run = std::sqrt(at_x * dx_ * at_x * dx_ + at_y * dy_ * at_y * dy_);
      rise = std::max(rise, (h - height(x, y)) / run);
    }
    constexpr double kLampSize = 0.12;
    return std::clamp(0.5 + (l[2] / level - rise) / (2 * kLampSize), 0.0, 1.0);
  }

  const CanvasState& s_;
  double strength_, scale_, dx_, dy_;
  HorizonLines lines_;
};

}  // namespace pentimento::reference

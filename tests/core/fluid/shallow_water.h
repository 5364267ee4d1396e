#pragma once
// Exact solutions of the shallow water equations, g = 9.81, as collected by Delestre et al.,
// SWASHES, Int. J. Numer. Methods Fluids 72 (2013) 269-300. tests/data/shallow-water has tables of
// them from another implementation.

#include <cmath>

namespace pentimento::shallow_water {

inline constexpr double kG = 9.81;

struct Flow {
  double depth_m = 0, u_m_s = 0, v_m_s = 0;
};

/// A dam at x = 0 gives way at t = 0: depth `left` against `right` > 0 (Stoker) or 0 (Ritter).
class DamBreak {
 public:
  DamBreak(double left_m, double right_m) : left_(left_m), right_(right_m) {
    double low = right_, high = left_;
    for (int i = 0; i < 200; ++i) {
      const double middle = 0.5 * (low + high);
      (excess(middle) > 0 ? high : low) = middle;
    }
    middle_ = 0.5 * (low + high);
  }
  Flow at(double x_m, double t_s) const {
    const double c = std::sqrt(kG * left_);
    const double c_middle = right_ > 0 ? std::sqrt(kG * middle_) : 0.0;
    const double u_middle = 2 * (c - c_middle);
    const double xi = x_m / t_s;
    if (xi < -c) return {left_, 0, 0};
    if (xi < u_middle - c_middle) {
      const double root = (2 * c - xi) / 3;
      return {root * root / kG, 2 * (xi + c) / 3, 0};
    }
    if (right_ > 0 && xi < middle_ * u_middle / (middle_ - right_)) return {middle_, u_middle, 0};
    return {right_, 0, 0};
  }

 private:
  // Rankine-Hugoniot: zero where the bore's velocity fits the rarefaction's.
  double excess(double h) const {
    if (!(right_ > 0)) return 1;
    const double bore = (h - right_) * std::sqrt(0.5 * kG * (1 / h + 1 / right_));
    return bore - 2 * (std::sqrt(kG * left_) - std::sqrt(kG * h));
  }
  double left_, right_, middle_ = 0;
};

/// Thacker's paraboloid on 4 m x 4 m: bed height above the lowest still level's shore, and flow.
inline double bowl_m(double x_m, double y_m) {
  const double dx = x_m - 2, dy = y_m - 2;
  return -0.1 * (1 - (dx * dx + dy * dy));
}
/// A plane surface that goes round once in kPlanarPeriod.
inline const double kPlanarOmega = std::sqrt(2 * kG * 0.1);
inline Flow thacker_planar(double x_m, double y_m, double t_s) {
  const double c = std::cos(kPlanarOmega * t_s), s = std::sin(kPlanarOmega * t_s);
  const double surface = 0.5 * 0.1 * (2 * (x_m - 2) * c + 2 * (y_m - 2) * s - 0.5);
  const double depth = surface - bowl_m(x_m, y_m);
  if (depth <= 0) return {};
  return {depth, -0.5 * kPlanarOmega * s, 0.5 * kPlanarOmega * c};
}
/// A paraboloid that swells and sinks.
inline const double kRadialOmega = std::sqrt(8 * kG * 0.1);
inline Flow thacker_radial(double x_m, double y_m, double t_s) {
  const double a = (1 - 0.64) / (1 + 0.64);
  const double below = 1 - a * std::cos(kRadialOmega * t_s);
  const double dx = x_m - 2, dy = y_m - 2;
  const double r2 = dx * dx + dy * dy;
  const double surface =
      0.1 * (std::sqrt(1 - a * a) / below - 1 - r2 * ((1 - a * a) / (below * below) - 1));
  const double depth = surface - bowl_m(x_m, y_m);
  if (depth <= 0) return {};
  const double rate = 0.5 * kRadialOmega * a * std::sin(kRadialOmega * t_s) / below;
  return {depth, rate * dx, rate * dy};
}

}  // namespace pentimento::shallow_water

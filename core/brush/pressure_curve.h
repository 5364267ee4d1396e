#pragma once
// How a factor follows the pressure: straight lines between points. A plain value.

#include <array>

namespace pentimento {

inline constexpr int kMostCurvePoints = 16;

struct PressureCurve {
  struct PressurePoint {
    float pressure = 0;  // 0..1, rising from point to point
    float value = 0;
    bool operator==(const PressurePoint&) const = default;
  };
  int count = 0;  // 0: no curve
  std::array<PressurePoint, kMostCurvePoints> points{};

  bool empty() const { return count == 0; }
  /// The value at a pressure. Before the first and after the last point it is that point's value.
  /// The curve must have a point.
  float at(float pressure) const {
    if (!(pressure > points[0].pressure)) return points[0].value;
    for (int i = 1; i < count; ++i) {
      const PressurePoint& a = points[static_cast<std::size_t>(i - 1)];
      const PressurePoint& b = points[static_cast<std::size_t>(i)];
      if (pressure < b.pressure)
        return a.value +
               (b.value - a.value) * ((pressure - a.pressure) / (b.pressure - a.pressure));
    }
    return points[static_cast<std::size_t>(count - 1)].value;
  }
  bool operator==(const PressureCurve&) const = default;
};

}  // namespace pentimento

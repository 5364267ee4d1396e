#pragma once
// From a pen's altitude and azimuth to the two tilts of the action log. Pure function.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace pentimento::sketch {

/// Altitude (rad; pi/2 is upright) and azimuth (rad; 0 leans right, clockwise as seen) to tilt_x
/// and tilt_y in degrees, -90..90:
///   tilt_x = atan(cos(azimuth) / tan(altitude)), tilt_y = atan(sin(azimuth) / tan(altitude))
/// Source: W3C Pointer Events 3, sec. 8.2. An altitude outside 0..pi/2 counts as the nearest.
inline std::pair<float, float> tilts_deg(double altitude_rad, double azimuth_rad) {
  const double altitude = std::clamp(altitude_rad, 0.0, std::numbers::pi / 2);
  const double lean = std::cos(altitude), rise = std::sin(altitude);
  const auto degrees = [](double rad) { return static_cast<float>(rad * 180 / std::numbers::pi); };
  return {degrees(std::atan2(std::cos(azimuth_rad) * lean, rise)),
          degrees(std::atan2(std::sin(azimuth_rad) * lean, rise))};
}

}  // namespace pentimento::sketch

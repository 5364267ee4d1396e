#pragma once
// A stamp: one placement of the tip on the canvas (R21). The stroke's path makes it, the transfer
// does it.

#include <algorithm>
#include <cstdint>

#include "core/base/vec.h"

namespace pentimento {

struct Stamp {
  double x_m = 0;  // centre on the canvas, from the top left, y down; may lie off the canvas
  double y_m = 0;
  double time_s = 0;     // in the time of the touch's samples
  float diameter_m = 0;  // > 0, of the unpressed brush
  float pressure = -1;   // 0..1; negative = the device has none
  float tilt_x_rad = 0;  // as W3C pointer events: positive = towards +x
  float tilt_y_rad = 0;  // positive = towards the user, +y (down)
  float twist_rad = 0;   // clockwise as seen by the painter
  Vec2f direction;       // unit vector of travel, y down; (0,0) for a tap
  Vec2f heading;         // direction smoothed along the path, for tips that turn with the stroke;
                         // does not turn round when the brush is pulled back; (0,0) for a tap
  Vec2f dab;             // unit vector that a round tip is turned to where a touch stands still;
                         // (0,0) while it travels
  float travel_m = 0;    // arc length this stamp stands for, >= 0
  Vec2f velocity_m_s;    // of the brush, y down
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

/// 0..1; a device that has no pressure presses fully.
inline float pressure_of(const Stamp& stamp) {
  return stamp.pressure < 0 ? 1.0f : std::min(stamp.pressure, 1.0f);
}

}  // namespace pentimento

#pragma once
// Where a lamp stands as the tablet turns (R32, A31).

#include <array>

#include "core/optics/lighting.h"

namespace pentimento {

/// Direction towards the lamp, unit length, in the viewer's frame (x right, y up, z out of the
/// canvas). `gravity` is the accelerometer's reading in the same frame: (0,0,9.81) lying face up,
/// (0,9.81,0) held upright; its direction is the room's "up".
///
/// A lamp that does not follow gravity keeps `lamp.direction`. A lamp that follows it is fixed in
/// the room: `lamp.direction` is its direction as seen from a tablet that lies face up. A tablet
/// with another "up" sees the lamp rotated by the shortest rotation from z to that "up", for a turn
/// about the vertical leaves no trace in gravity. So a lamp straight above, (0,0,1), has the
/// direction of the reading. If the tablet lies face down, the rotation is half a turn about x. A
/// reading under 0.1 m/s^2 (free fall) gives no direction, and nothing is rotated.
std::array<float, 3> lamp_direction(const Lamp& lamp, std::array<float, 3> gravity);

/// The same for the position of a lamp that has one: it is turned about the canvas's centre.
std::array<float, 3> lamp_position(const Lamp& lamp, std::array<float, 3> gravity);

}  // namespace pentimento

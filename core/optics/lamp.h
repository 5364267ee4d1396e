#pragma once
// Where a lamp stands as the tablet turns (R32, A31).

#include <array>

#include "core/optics/lighting.h"

namespace pentimento {

/// Direction towards the lamp, unit length, in the viewer's frame (x right, y up, z out of the
/// canvas). `gravity` is the accelerometer's reading in the same frame: (0,0,9.81) lying face up,
/// (0,9.81,0) held upright; its direction is the room's "up".
///
/// A lamp that does not follow keeps `lamp.direction`. One that does is fixed in the room, where
/// `lamp.direction` says it is seen from a tablet lying face up; a tablet with another "up" sees it
/// rotated by the shortest rotation from z to there, since a turn about the vertical leaves no
/// trace in gravity. A lamp straight above, (0,0,1), is thus the normalised gravity. Face down, the
/// rotation is half a turn about x. Readings under 0.1 m/s^2 (free fall) tell nothing: no rotation.
std::array<float, 3> lamp_direction(const Lamp& lamp, std::array<float, 3> gravity);

/// The same of the place of a lamp that has one: turned about the canvas's centre.
std::array<float, 3> lamp_position(const Lamp& lamp, std::array<float, 3> gravity);

}  // namespace pentimento

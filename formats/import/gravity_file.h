#pragma once
// Recordings of a device's accelerometer or attitude, as gravity of the action log: m/s^2, flat and
// face up (0, 0, +9.81), upright (0, +9.81, 0), as Android has it.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/import/sketch/recording.h"
#include "formats/log/tables/events.h"

namespace pentimento::sketch {

struct GravityOptions {
  std::string
      as;  // coremotion, android, devicemotion or devicemotion-ios; empty: told by the columns
  int turn_deg = 0;  // screen.orientation.angle while it was recorded: 0, 90, 180 or 270
};

/// What a file of gravity holds; times from its first reading.
struct GravityRecording {
  std::string kind;
  std::vector<log::Event> readings;
};

/// Reads
///   coremotion: a table with grav_x_g, grav_y_g, grav_z_g (or gravity_x ...), in g, flat z = -1,
///     times in seconds;
///   android: a table with x, y, z in m/s^2, flat z = +9.81, timestamps in ns, ms or s;
///   devicemotion: JSON lines, or an array, of W3C DeviceMotionEvents with
///     accelerationIncludingGravity, flat z = +9.8, timeStamp in ms; -ios has the opposite sign.
/// Errors: kBadInput "file:line: what".
Result<GravityRecording> read_gravity(const Source& source, const GravityOptions& options);

}  // namespace pentimento::sketch

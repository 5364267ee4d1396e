#pragma once
// Which samples of a stroke its curve needs. Pure function.

#include <cstdint>
#include <vector>

#include "formats/log/tables/events.h"

namespace pentimento::log {

/// What may be lost where a sample is left out.
struct SplineTolerance {
  double place_m = 5e-4;     // across the curve, and of `radius`
  double time_s = 2.0 / 45;  // two steps of the simulation
  double pressure = 0.02;    // pens scatter as much
  double angle_deg = 1;      // of tilt and twist
};

/// A sample of one touch, and when.
struct TimedTouch {
  std::int64_t time_us = 0;
  Touch touch;
  bool keep = false;  // must stay
};

/// Sets `keep` of so many samples that the painter's curve through them (centripetal spline; all
/// but the place goes evenly from sample to sample) comes within the tolerance of every other
/// sample: in place, and there in all else. The first and the last stay. Begins with those that
/// must stay and adds the worst of each piece until none is too far away.
void keep_for_spline(std::vector<TimedTouch>& samples, const SplineTolerance& tolerance);

}  // namespace pentimento::log

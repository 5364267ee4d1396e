#pragma once
// The parts of /lighting that dumps did not always have: a place of the first lamp, further lamps,
// varnish, occlusion, white point and tone curve. What a dump lacks has its default. For the .cpp
// files of this folder only.

#include <hdf5.h>

#include <vector>

#include "core/optics/lighting.h"

namespace pentimento::hdf5 {

/// /lighting/lamp_position and /lighting/more_lamps, where there is something to say.
bool write_lamps(hid_t file, const std::vector<Lamp>& lamps);
/// The first lamp is there already. False: datasets of a wrong shape.
bool read_lamps(hid_t file, std::vector<Lamp>& lamps);

/// False: a value that no picture can be shaded with.
bool read_development(hid_t lighting, Lighting& light);

}  // namespace pentimento::hdf5

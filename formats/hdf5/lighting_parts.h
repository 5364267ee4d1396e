#pragma once
// The parts of /lighting that older dumps do not have: the position of the first lamp, further
// lamps, varnish, occlusion, white point and tone curve. A part that is missing has its default.
// For the .cpp files of this folder only.

#include <hdf5.h>

#include <vector>

#include "core/optics/lighting.h"

namespace pentimento::hdf5 {

/// Light beyond this, either way, does not stay finite in single precision.
inline constexpr float kMostLight = 1e12f;

/// Writes /lighting/lamp_position and /lighting/more_lamps if a lamp has a position or there is
/// more than one. False if HDF5 failed.
bool write_lamps(hid_t file, const std::vector<Lamp>& lamps);
/// Reads what write_lamps() wrote. The first lamp must be in `lamps` already. False: datasets of a
/// wrong shape, or a lamp with which no picture can be shaded.
bool read_lamps(hid_t file, std::vector<Lamp>& lamps);

/// Reads varnish, occlusion, white point and tone curve. False: a value with which no picture can
/// be shaded.
bool read_development(hid_t lighting, Lighting& light);

}  // namespace pentimento::hdf5

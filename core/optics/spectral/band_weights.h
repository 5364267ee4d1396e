#pragma once
// From the reflectances of a canvas's bands to the colour they look like. For pictures only.

#include <Eigen/Core>
#include <span>

#include "core/model/viewing.h"

namespace pentimento {

/// Linear sRGB (as rgb_weights()) per band of `wavelength_nm`, 3 x bands. For all 38 samples these
/// are rgb_weights() themselves. For fewer they are fitted to give the XYZ of the 38 over mixtures
/// of the measured paints and smooth colours: least squares, each colour counting as its lightness
/// makes errors seen (Y^-4/3), then rounds in which what differs most (CIEDE2000) counts more, and
/// the round with the smallest largest difference is taken. A perfect white stays exact. At least 3
/// wavelengths, rising.
Eigen::Matrix3Xd band_rgb_weights(std::span<const double> wavelength_nm, const Viewing& viewing);

/// The same to XYZ with Y = 1 for a perfect white.
Eigen::Matrix3Xd band_xyz_weights(std::span<const double> wavelength_nm, const Viewing& viewing);

}  // namespace pentimento

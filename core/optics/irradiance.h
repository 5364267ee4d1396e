#pragma once
// Diffuse light from all around as nine spherical harmonics (Ramamoorthi and Hanrahan 2001), and
// the projection of a panorama onto them. For pictures only: nothing here reaches the state.

#include <array>

#include "core/base/field.h"
#include "core/optics/lighting.h"

namespace pentimento {

/// Irradiance on a surface with unit normal `n`, per RGB. It is cut at 0, for nine terms can become
/// negative opposite a point light. Radiance 1 all around gives pi. Source: RH01, eq. 13.
std::array<float, 3> sh_irradiance(const ShCoefficients& light, std::array<float, 3> n);

/// Radiance from unit direction `d`, blurred as nine terms are, and cut at 0.
std::array<float, 3> sh_radiance(const ShCoefficients& light, std::array<float, 3> d);

/// The nine real spherical harmonics at unit direction `d`, in the order of ShCoefficients.
std::array<double, 9> sh_basis(std::array<double, 3> d);

/// Unit direction in the viewer's frame of the point (u, v) of a panorama, u, v in [0,1] from its
/// top left. The panorama is as seen by someone at the canvas: its centre (0.5, 0.5) is +z, towards
/// the viewer; its top is +y; its right half lies at -x, which is to the right of somebody who
/// looks along +z.
std::array<double, 3> panorama_direction(double u, double v);

/// Coefficients of an equirectangular panorama in linear RGB: each pixel weighted with its exact
/// solid angle, summed in double, row by row. Planes of equal size, at least 1 x 1.
ShCoefficients project_panorama(const std::array<FieldView<const float>, 3>& rgb);

}  // namespace pentimento

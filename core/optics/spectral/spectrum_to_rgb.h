#pragma once
// A pigment measured per wavelength, as the three bands of an RGB picture see it. Reaches the
// state: own arithmetic only.

#include <span>
#include <string>

#include "core/model/viewing.h"
#include "core/optics/channels.h"

namespace pentimento {

/// Coefficients at rising wavelengths; at least one, equally many of each.
struct MeasuredSpectrum {
  std::span<const double> wavelength_nm, K, S;
};

/// `value` at `at_nm`: linear between the wavelengths, constant beyond them.
double at_wavelength(std::span<const double> wavelength_nm, std::span<const double> value,
                     double at_nm);

/// The RGB pigment whose film of optical thickness 1 looks over white and over black as the
/// spectral one does through the interface. Reflectances are integrated with the colour matching
/// functions of Wyman, Sloan, Shirley (JCGT 2(2), 2013), taken to linear sRGB and scaled so that
/// reflectance 1 gives (1,1,1).
Pigment pigment_from_spectrum(const std::string& name, const MeasuredSpectrum& spectrum,
                              const Saunderson& interface = {});

}  // namespace pentimento

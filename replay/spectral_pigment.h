#pragma once
// A pigment measured per wavelength, as the three bands of the picture see it. Reaches the state:
// own arithmetic only.

#include "core/optics/channels.h"
#include "formats/log/events.h"

namespace pentimento {

/// The RGB pigment whose film of optical thickness 1 looks over white and over black as the
/// spectral one does. Reflectances are integrated with the colour matching functions of Wyman,
/// Sloan, Shirley (JCGT 2(2), 2013), taken to linear sRGB and scaled so that reflectance 1 gives
/// (1,1,1); values between the wavelengths are linear, beyond them constant. At least one
/// wavelength, ascending.
Pigment pigment_from_spectrum(const std::string& name, const log::PigmentSpec::Spectrum& spectrum);

}  // namespace pentimento

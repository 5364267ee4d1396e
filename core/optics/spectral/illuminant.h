#pragma once
// The light under which paint is looked at: relative spectral power of the CIE's illuminants.
// Reaches the state through the upsampling of colours: no C library functions.

#include "core/optics/spectral/observer.h"

namespace pentimento {

/// Relative power at each sample, about 100 at 560 nm. A and the D series by their formulas (D
/// rounded as the CIE rounds it and linear between its 10 nm), E constant, F2 and F11 tables.
/// Source: CIE 15:2018.
CieSpectrum illuminant_power(Illuminant illuminant);

}  // namespace pentimento

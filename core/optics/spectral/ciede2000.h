#pragma once
// CIELAB and the CIEDE2000 colour difference. For tests and choices of bands; never for the state.

#include "core/optics/spectral/observer.h"

namespace pentimento {

struct Lab {
  double L = 0, a = 0, b = 0;
};

/// CIELAB of `xyz` seen beside `white` (CIE 15:2018, 8.2.1). Components >= 0.
Lab lab_of(const Xyz& xyz, const Xyz& white);

/// Hue angle in degrees, 0..360, and chroma of a colour.
double hue_deg(const Lab& color);
double chroma(const Lab& color);

/// CIEDE2000 with kL = kC = kH = 1. Source: Sharma, Wu, Dalal, The CIEDE2000 Color-Difference
/// Formula: Implementation Notes, Color Research and Application 30(1), 2005.
double ciede2000(const Lab& first, const Lab& second);

}  // namespace pentimento

#pragma once
// From scene-linear light to what a display shows. The white point is linear and part of every
// picture; the tone curve is only for pictures for a display. Nothing here reaches the state.

#include <array>
#include <optional>
#include <string_view>

#include "core/optics/lighting.h"

namespace pentimento {

/// "none", "soft", "filmic".
std::string_view tone_curve_name(ToneCurve curve);
std::optional<ToneCurve> tone_curve_of(std::string_view name);

/// A channel's display value, before sRGB encoding, of light x >= 0; never falls as x rises.
///   none:   x
///   soft:   x up to 0.7, then 1 - 0.3 / (1 + (x - 0.7) / 0.3): the slope is continuous, 1 is
///           reached at infinity
///   filmic: x (2.51 x + 0.03) / (x (2.43 x + 0.59) + 0.14), at most 1
/// Source of filmic: Narkowicz 2016, fit of the ACES film curve. Departs from it: none.
float tone(ToneCurve curve, float x);

/// Row-major matrix of linear sRGB that makes light of chromaticity `white_xy` neutral; exactly the
/// identity for D65. Source: Bradford's cone responses (Lam 1985), scaled (von Kries).
std::array<std::array<float, 3>, 3> white_balance(std::array<float, 2> white_xy);

/// CIE xy of a black body or of daylight of this temperature, 1667..25000 K. Source: Kim et al.
/// 2002 below 4000 K, CIE daylight locus from 4000 K on.
std::array<float, 2> white_of_temperature(double kelvin);

}  // namespace pentimento

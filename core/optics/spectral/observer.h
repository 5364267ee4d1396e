#pragma once
// How an eye of the CIE sees: colour matching functions.

#include <array>

#include "core/model/viewing.h"

namespace pentimento {

using Xyz = std::array<double, 3>;

/// Samples of every CIE table here: 380, 385 .. 780 nm.
inline constexpr int kCieSamples = 81;
constexpr double cie_wavelength_nm(int sample) {
  return 380 + 5 * sample;
}
using CieSpectrum = std::array<double, kCieSamples>;

/// x, y, z bar of the observer (CIE 15:2018).
const std::array<Xyz, kCieSamples>& color_matching(Observer observer);

}  // namespace pentimento

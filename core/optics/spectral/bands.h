#pragma once
// The wavelengths at which paint is carried through a session when fewer than a measured spectrum's
// are enough (docs/optics.md has how they were found and what each number of them costs in colour).

#include <span>
#include <vector>

#include "core/optics/spectral/spectrum.h"

namespace pentimento {

/// The numbers of bands there are sets for, rising.
std::span<const int> band_counts();

/// Centres of a set of `bands` in nm, rising; empty if there is none. 38: all samples of a
/// spectrum.
std::vector<double> band_wavelengths_nm(int bands);

/// A spectrum at wavelengths in nm: linear between its samples, constant beyond them.
std::vector<double> sampled_at(const Spectrum& spectrum, std::span<const double> wavelength_nm);

}  // namespace pentimento

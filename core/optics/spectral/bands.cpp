#include "core/optics/spectral/bands.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace pentimento {
namespace {

struct BandSet {
  int count;
  std::array<double, 16> nm;
};

// Found by annealing over a grid of 5 nm (docs/optics.md).
constexpr BandSet kSets[] = {
    {8, {430, 465, 495, 520, 545, 570, 605, 650}},
    {9, {435, 465, 495, 520, 545, 575, 600, 640, 720}},
    {10, {420, 450, 475, 500, 520, 545, 570, 595, 625, 670}},
    {11, {425, 450, 475, 485, 510, 530, 550, 570, 590, 620, 665}},
    {12, {425, 450, 475, 490, 510, 530, 550, 570, 590, 615, 640, 680}},
    {13, {420, 440, 460, 475, 495, 510, 530, 550, 570, 590, 615, 640, 685}},
    {14, {400, 430, 455, 480, 495, 510, 530, 550, 560, 570, 590, 610, 640, 685}},
    {15, {420, 445, 465, 470, 490, 510, 530, 550, 560, 570, 590, 610, 645, 655, 685}},
};
constexpr std::array<int, std::size(kSets) + 1> kCounts = [] {
  std::array<int, std::size(kSets) + 1> counts{};
  for (std::size_t i = 0; i < std::size(kSets); ++i) counts[i] = kSets[i].count;
  counts.back() = kSpectrumSamples;
  return counts;
}();

}  // namespace

std::span<const int> band_counts() {
  return kCounts;
}

std::vector<double> band_wavelengths_nm(int bands) {
  std::vector<double> nm;
  for (const BandSet& set : kSets)
    if (set.count == bands) nm.assign(set.nm.begin(), set.nm.begin() + bands);
  if (bands == kSpectrumSamples)
    for (int i = 0; i < bands; ++i) nm.push_back(spectrum_wavelength_nm(i));
  return nm;
}

std::vector<double> sampled_at(const Spectrum& spectrum, std::span<const double> wavelength_nm) {
  constexpr double kFirst_nm = spectrum_wavelength_nm(0);
  constexpr double kStep_nm = spectrum_wavelength_nm(1) - kFirst_nm;
  std::vector<double> out;
  for (const double nm : wavelength_nm) {
    const double at =
        std::clamp((nm - kFirst_nm) / kStep_nm, 0.0, static_cast<double>(kSpectrumSamples - 1));
    const std::size_t below = std::min(static_cast<std::size_t>(at), spectrum.size() - 2);
    const double u = at - static_cast<double>(below);
    out.push_back(spectrum[below] + (spectrum[below + 1] - spectrum[below]) * u);
  }
  return out;
}

}  // namespace pentimento

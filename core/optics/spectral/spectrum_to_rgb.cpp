#include "core/optics/spectral/spectrum_to_rgb.h"

#include <algorithm>
#include <array>

#include "core/base/approx.h"
#include "core/optics/kubelka_munk.h"

namespace pentimento {

namespace {

/// One lobe of the fit: a Gaussian with its own width on each side of the peak.
double lobe(double nm, double height, double peak_nm, double left, double right) {
  const double t = (nm - peak_nm) * (nm < peak_nm ? left : right);
  return height * approx::exp(-0.5 * t * t);
}

/// Weights of one wavelength in linear sRGB, not yet normalised.
std::array<double, 3> rgb_weight(double nm) {
  const double x = lobe(nm, 0.362, 442.0, 0.0624, 0.0374) + lobe(nm, 1.056, 599.8, 0.0264, 0.0323) -
                   lobe(nm, 0.065, 501.1, 0.0490, 0.0382);
  const double y = lobe(nm, 0.821, 568.8, 0.0213, 0.0247) + lobe(nm, 0.286, 530.9, 0.0613, 0.0322);
  const double z = lobe(nm, 1.217, 437.0, 0.0845, 0.0278) + lobe(nm, 0.681, 459.0, 0.0385, 0.0725);
  return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
          -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
          0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

/// Through the interface; without one, bit for bit what is inside.
double seen(double inside, const Saunderson& interface) {
  return interface.none() ? inside : saunderson_seen(inside, interface.k1, interface.k2);
}

}  // namespace

double at_wavelength(std::span<const double> nm, std::span<const double> value, double at) {
  const auto above = std::upper_bound(nm.begin(), nm.end(), at);
  if (above == nm.begin()) return value.front();
  if (above == nm.end()) return value.back();
  const auto i = static_cast<std::size_t>(above - nm.begin());
  const double u = (at - nm[i - 1]) / (nm[i] - nm[i - 1]);
  return value[i - 1] + (value[i] - value[i - 1]) * u;
}

Pigment pigment_from_spectrum(const std::string& name, const MeasuredSpectrum& spectrum,
                              const Saunderson& interface) {
  constexpr int kFirstNm = 380;
  constexpr int kLastNm = 750;
  std::array<double, 3> white{}, black{}, norm{};
  for (int nm = kFirstNm; nm <= kLastNm; ++nm) {
    const KmFilm film = km_film({at_wavelength(spectrum.wavelength_nm, spectrum.K, nm),
                                 at_wavelength(spectrum.wavelength_nm, spectrum.S, nm)},
                                1.0);
    const std::array<double, 3> weight = rgb_weight(nm);
    for (std::size_t b = 0; b < 3; ++b) {
      white[b] += weight[b] * seen(km_over(film, 1.0), interface);
      black[b] += weight[b] * seen(film.R, interface);
      norm[b] += weight[b];
    }
  }
  std::array<float, 3> over_white{}, over_black{};
  for (std::size_t b = 0; b < 3; ++b) {
    over_white[b] = static_cast<float>(std::clamp(white[b] / norm[b], 0.0, 1.0));
    over_black[b] = static_cast<float>(std::clamp(black[b] / norm[b], 0.0, 1.0));
  }
  return pigment_from_white_black(name, over_white, over_black);
}

}  // namespace pentimento

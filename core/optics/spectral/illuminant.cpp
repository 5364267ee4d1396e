#include "core/optics/spectral/illuminant.h"

#include "core/base/approx.h"

namespace pentimento {
namespace {

// CIE 15:2018: fluorescent lamps at 5 nm; mean and first two components of daylight at 10 nm.
// clang-format off
constexpr CieSpectrum kF2 = {
    1.18, 1.48, 1.84, 2.15, 3.44, 15.69, 3.85, 3.74, 4.19, 4.62,
    5.06, 34.98, 11.81, 6.27, 6.63, 6.93, 7.19, 7.4, 7.54, 7.62,
    7.65, 7.62, 7.62, 7.45, 7.28, 7.15, 7.05, 7.04, 7.16, 7.47,
    8.04, 8.88, 10.01, 24.88, 16.64, 14.59, 16.16, 17.56, 18.62, 21.47,
    22.79, 19.29, 18.66, 17.73, 16.54, 15.21, 13.8, 12.36, 10.95, 9.65,
    8.4, 7.32, 6.31, 5.43, 4.68, 4.02, 3.45, 2.96, 2.55, 2.19,
    1.89, 1.64, 1.53, 1.27, 1.1, 0.99, 0.88, 0.76, 0.68, 0.61,
    0.56, 0.54, 0.51, 0.47, 0.47, 0.43, 0.46, 0.47, 0.4, 0.33,
    0.27,
};

constexpr CieSpectrum kF11 = {
    0.91, 0.63, 0.46, 0.37, 1.29, 12.68, 1.59, 1.79, 2.46, 3.33,
    4.49, 33.94, 12.13, 6.95, 7.19, 7.12, 6.72, 6.13, 5.46, 4.79,
    5.66, 14.29, 14.96, 8.97, 4.72, 2.33, 1.47, 1.1, 0.89, 0.83,
    1.18, 4.9, 39.59, 72.84, 32.61, 7.52, 2.83, 1.96, 1.67, 4.43,
    11.28, 14.76, 12.73, 9.74, 7.33, 9.72, 55.27, 42.58, 13.18, 13.16,
    12.26, 5.11, 2.07, 2.34, 3.58, 3.01, 2.48, 2.14, 1.54, 1.33,
    1.46, 1.94, 2, 1.2, 1.35, 4.1, 5.58, 2.51, 0.57, 0.27,
    0.23, 0.21, 0.24, 0.24, 0.2, 0.24, 0.32, 0.26, 0.16, 0.12,
    0.09,
};

constexpr std::array<std::array<double, 3>, 41> kDaylight = {{
    {63.4, 38.5, 3}, {65.8, 35, 1.2}, {94.8, 43.4, -1.1}, {104.8, 46.3, -0.5},
    {105.9, 43.9, -0.7}, {96.8, 37.1, -1.2}, {113.9, 36.7, -2.6}, {125.6, 35.9, -2.9},
    {125.5, 32.6, -2.8}, {121.3, 27.9, -2.6}, {121.3, 24.3, -2.6}, {113.5, 20.1, -1.8},
    {113.1, 16.2, -1.5}, {110.8, 13.2, -1.3}, {106.5, 8.6, -1.2}, {108.8, 6.1, -1},
    {105.3, 4.2, -0.5}, {104.4, 1.9, -0.3}, {100, 0, 0}, {96, -1.6, 0.2},
    {95.1, -3.5, 0.5}, {89.1, -3.5, 2.1}, {90.5, -5.8, 3.2}, {90.3, -7.2, 4.1},
    {88.4, -8.6, 4.7}, {84, -9.5, 5.1}, {85.1, -10.9, 6.7}, {81.9, -10.7, 7.3},
    {82.6, -12, 8.6}, {84.9, -14, 9.8}, {81.3, -13.6, 10.2}, {71.9, -12, 8.3},
    {74.3, -13.3, 9.6}, {76.4, -12.9, 8.5}, {63.3, -10.6, 7}, {71.7, -11.6, 7.6},
    {77, -12.2, 8}, {65.2, -10.2, 6.7}, {47.7, -7.8, 5.2}, {68.6, -11.2, 7.4},
    {65, -10.4, 6.8},
}};
// clang-format on

/// Thousandths, as the CIE rounds the weights of daylight's components.
double to_thousandths(double x) {
  return static_cast<double>(static_cast<int>(1000 * x + (x < 0 ? -0.5 : 0.5))) / 1000;
}

/// Daylight of a nominal temperature, which the CIE gave for c2 = 0.01438 m K (eqs. 6.1 to 6.4).
CieSpectrum daylight(double nominal_K) {
  const double T = nominal_K * (1.4388 / 1.4380);
  const double x = T <= 7000 ? ((-4.6070e9 / T + 2.9678e6) / T + 99.11) / T + 0.244063
                             : ((-2.0064e9 / T + 1.9018e6) / T + 247.48) / T + 0.237040;
  const double y = (-3 * x + 2.870) * x - 0.275;
  const double d = 0.0241 + 0.2562 * x - 0.7341 * y;
  const double m1 = to_thousandths((-1.3515 - 1.7703 * x + 5.9114 * y) / d);
  const double m2 = to_thousandths((0.0300 - 31.4424 * x + 30.0717 * y) / d);
  const auto power = [&](std::size_t i) {
    return kDaylight[i][0] + m1 * kDaylight[i][1] + m2 * kDaylight[i][2];
  };
  CieSpectrum out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = (power(i / 2) + power((i + 1) / 2)) / 2;
  return out;
}

/// Illuminant A: Planck's law at 2848 K with c2 = 0.01435 m K, 100 at 560 nm.
CieSpectrum incandescent() {
  constexpr double kExponent_nm = 1.435e7 / 2848;
  CieSpectrum out{};
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double nm = cie_wavelength_nm(static_cast<int>(i)), r = 560 / nm;
    out[i] = 100 * r * r * r * r * r * approx::expm1(kExponent_nm / 560) /
             approx::expm1(kExponent_nm / nm);
  }
  return out;
}

CieSpectrum equal_energy() {
  CieSpectrum out{};
  out.fill(100);
  return out;
}

}  // namespace

CieSpectrum illuminant_power(Illuminant illuminant) {
  switch (illuminant) {
    case Illuminant::kA:
      return incandescent();
    case Illuminant::kD50:
      return daylight(5000);
    case Illuminant::kD55:
      return daylight(5500);
    case Illuminant::kD65:
      return daylight(6500);
    case Illuminant::kD75:
      return daylight(7500);
    case Illuminant::kE:
      return equal_energy();
    case Illuminant::kF2:
      return kF2;
    case Illuminant::kF11:
      break;
  }
  return kF11;
}

}  // namespace pentimento

#include "core/optics/spectral/ciede2000.h"

#include <cmath>

namespace pentimento {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180;

double cos_deg(double degrees) {
  return std::cos(degrees * kRadiansPerDegree);
}
double sin_deg(double degrees) {
  return std::sin(degrees * kRadiansPerDegree);
}
/// Angle of (a, b) in [0,360); 0 for grey.
double angle_deg(double a, double b) {
  if (a == 0 && b == 0) return 0;
  const double degrees = std::atan2(b, a) / kRadiansPerDegree;
  return degrees < 0 ? degrees + 360 : degrees;
}

double lightness_curve(double t) {
  constexpr double kBend = 216.0 / 24389, kSlope = 24389.0 / 27;
  return t > kBend ? std::cbrt(t) : (kSlope * t + 16) / 116;
}

/// sqrt(c^7 / (c^7 + 25^7)).
double high_chroma(double c) {
  const double c7 = std::pow(c, 7);
  return std::sqrt(c7 / (c7 + 6103515625.0));
}

/// A colour with its a' (eqs. 5 to 7).
struct Primed {
  double L, C, h_deg;
};
Primed primed(const Lab& c, double mean_chroma) {
  const double a = c.a * (1 + 0.5 * (1 - high_chroma(mean_chroma)));
  return {c.L, std::hypot(a, c.b), angle_deg(a, c.b)};
}

/// Difference of hue in degrees, -180..180 (eq. 10).
double hue_difference(const Primed& p, const Primed& q) {
  if (p.C * q.C == 0) return 0;
  const double d = q.h_deg - p.h_deg;
  return d > 180 ? d - 360 : d < -180 ? d + 360 : d;
}

/// Mean hue in degrees (eq. 14).
double mean_hue(const Primed& p, const Primed& q) {
  const double sum = p.h_deg + q.h_deg;
  if (p.C * q.C == 0) return sum;
  if (std::abs(p.h_deg - q.h_deg) <= 180) return sum / 2;
  return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

}  // namespace

Lab lab_of(const Xyz& xyz, const Xyz& white) {
  const double x = lightness_curve(xyz[0] / white[0]), y = lightness_curve(xyz[1] / white[1]),
               z = lightness_curve(xyz[2] / white[2]);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double hue_deg(const Lab& color) {
  return angle_deg(color.a, color.b);
}

double chroma(const Lab& color) {
  return std::hypot(color.a, color.b);
}

double ciede2000(const Lab& first, const Lab& second) {
  const double mean_chroma = (chroma(first) + chroma(second)) / 2;
  const Primed p = primed(first, mean_chroma), q = primed(second, mean_chroma);
  const double dL = q.L - p.L, dC = q.C - p.C;
  const double dH = 2 * std::sqrt(p.C * q.C) * sin_deg(hue_difference(p, q) / 2);
  const double L = (p.L + q.L) / 2, C = (p.C + q.C) / 2, h = mean_hue(p, q);
  const double T = 1 - 0.17 * cos_deg(h - 30) + 0.24 * cos_deg(2 * h) + 0.32 * cos_deg(3 * h + 6) -
                   0.20 * cos_deg(4 * h - 63);
  const double L50 = (L - 50) * (L - 50);
  const double l = dL / (1 + 0.015 * L50 / std::sqrt(20 + L50));
  const double c = dC / (1 + 0.045 * C), hue = dH / (1 + 0.015 * C * T);
  const double bump = (h - 275) / 25;
  const double rotation = -sin_deg(60 * std::exp(-bump * bump)) * 2 * high_chroma(C);
  return std::sqrt(l * l + c * c + hue * hue + rotation * c * hue);
}

}  // namespace pentimento

#include "core/optics/kubelka_munk.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/approx.h"
#include "core/base/check.h"

namespace pentimento {
namespace {

/// atanh(q) for q in [0,1), where 1 - q^2 is known without cancellation.
double atanh_known(double q, double one_minus_q2) {
  if (q < 0.5) return 0.5 * approx::log1p(2 * q / (1 - q));
  return 0.5 * approx::log((1 + q) * (1 + q) / one_minus_q2);
}

/// exp(-z) sinh(z)/z, given e = exp(-z). The series ends below 1e-16 at z = 0.5.
double scaled_sinhc(double z, double e) {
  if (z >= 0.5) return (1 - e * e) / (2 * z);
  const double t = z * z;
  return e *
         (1 + t / 6 * (1 + t / 20 * (1 + t / 42 * (1 + t / 72 * (1 + t / 110 * (1 + t / 156))))));
}

}  // namespace

KmCoefficients km_from_white_black(double over_white, double over_black) {
  const double w = over_white, r = over_black;
  PENTIMENTO_CHECK(r > 0 && r < w && w <= 1);
  const double a_minus_1 = (1 - w) * (1 - r) / (2 * r);
  const double b = std::sqrt(a_minus_1 * (a_minus_1 + 2));
  const double q_per_b = 2 * r / ((1 + w) * (1 - r));
  const double q = q_per_b * b;
  const double one_minus_q2 = 4 * (w - r) / ((1 + w) * (1 + w) * (1 - r));
  // atanh(q)/b tends to q/b when b does to 0 (over_white = 1: nothing is absorbed).
  const double S = q > 0 ? atanh_known(q, one_minus_q2) / b : q_per_b;
  return {S * a_minus_1, S};
}

KmFilm km_film(KmCoefficients paint, double x) {
  PENTIMENTO_CHECK(paint.K >= 0 && paint.S >= 0 && x >= 0);
  const double K = paint.K * x, S = paint.S * x;
  const double z = std::sqrt(K * (K + 2 * S));
  // Numerator and denominator carry the factor exp(-z), so that cosh never overflows.
  const double e = approx::exp(-z);
  const double w = scaled_sinhc(z, e);
  const double d = 0.5 * (1 + e * e) + (K + S) * w;
  return {S * w / d, e / d};
}

KmFilm km_stack(KmFilm top, KmFilm below) {
  const double between = 1 - top.R * below.R;
  return {top.R + top.T * top.T * below.R / between, top.T * below.T / between};
}

double km_over(KmFilm film, double ground) {
  return km_stack(film, {ground, 0}).R;
}

double km_opaque(KmCoefficients paint) {
  // Without the cancellation of 1 + q - sqrt(q^2 + 2q): its product with 1 + q + sqrt(..) is 1.
  const double K = paint.K, S = paint.S;
  return S > 0 ? S / (S + K + std::sqrt(K * (K + 2 * S))) : 0;
}

double saunderson_seen(double inside, double k1, double k2) {
  return k1 + (1 - k1) * (1 - k2) * inside / (1 - k2 * inside);
}

double saunderson_inside(double seen, double k1, double k2) {
  return (seen - k1) / (1 - k1 - k2 + k2 * seen);
}

Pigment pigment_from_white_black(std::string name, std::array<float, 3> over_white,
                                 std::array<float, 3> over_black) {
  constexpr double kDarkest = 1.0 / 255, kLeastDifference = 1e-4;
  Pigment p{std::move(name), Eigen::VectorXd(3), Eigen::VectorXd(3)};
  for (int i = 0; i < 3; ++i) {
    const auto band = static_cast<std::size_t>(i);
    const double w = std::clamp(static_cast<double>(over_white[band]), 2 * kDarkest, 1 - kDarkest);
    const double b =
        std::clamp(static_cast<double>(over_black[band]), kDarkest, w - kLeastDifference);
    const KmCoefficients km = km_from_white_black(w, b);
    p.K(i) = km.K;
    p.S(i) = km.S;
  }
  return p;
}

Pigment pigment_from_color(std::string name, std::array<float, 3> color, float opacity) {
  std::array<float, 3> over_black{};
  for (std::size_t i = 0; i < 3; ++i) over_black[i] = opacity * color[i];
  return pigment_from_white_black(std::move(name), color, over_black);
}

}  // namespace pentimento

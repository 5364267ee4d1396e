#include "core/optics/microfacet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pentimento {
namespace {

/// Cosines that l, v and their half vector make with the normal z and with each other.
struct Geometry {
  double n_l, n_v, n_h, v_h;
};
Geometry geometry(const std::array<double, 3>& l, const std::array<double, 3>& v) {
  const double x = l[0] + v[0], y = l[1] + v[1], z = l[2] + v[2];
  const double length = std::sqrt(x * x + y * y + z * z);
  // v.h = l.h = |l + v|/2 for unit vectors: this form is symmetric to the last bit.
  return {l[2], v[2], length > 0 ? z / length : 0, std::min(length / 2, 1.0)};
}

}  // namespace

double fresnel(double cos_i, double n) {
  const double sin2_t = (1 - cos_i * cos_i) / (n * n);
  const double cos_t = std::sqrt(1 - sin2_t);
  const double s = (cos_i - n * cos_t) / (cos_i + n * cos_t);
  const double p = (n * cos_i - cos_t) / (n * cos_i + cos_t);
  return (s * s + p * p) / 2;
}

double fresnel_normal(double n) {
  return (n - 1) * (n - 1) / ((n + 1) * (n + 1));
}

double fresnel_schlick(double cos_i, double f0) {
  const double c = 1 - cos_i;
  return f0 + (1 - f0) * c * c * c * c * c;
}

double facet_density(FacetDistribution kind, double n_h, double a) {
  if (n_h <= 0) return 0;
  const double c2 = n_h * n_h, a2 = a * a;
  if (kind == FacetDistribution::kBeckmann) {
    return std::exp((c2 - 1) / (c2 * a2)) / (std::numbers::pi * a2 * c2 * c2);
  }
  const double t = c2 * (a2 - 1) + 1;
  return a2 / (std::numbers::pi * t * t);
}

double groove_attenuation(double n_h, double n_v, double n_l, double v_h) {
  return std::min(1.0, 2 * n_h * std::min(n_v, n_l) / v_h);
}

double facet_lobe(FacetDistribution kind, double a, const std::array<double, 3>& l,
                  const std::array<double, 3>& v) {
  const Geometry g = geometry(l, v);
  if (g.n_l <= 0 || g.n_v <= 0) return 0;
  return facet_density(kind, g.n_h, a) * groove_attenuation(g.n_h, g.n_v, g.n_l, g.v_h) /
         (4 * (g.n_l * g.n_v));
}

double torrance_sparrow(FacetDistribution kind, double a, double n, const std::array<double, 3>& l,
                        const std::array<double, 3>& v) {
  return fresnel(geometry(l, v).v_h, n) * facet_lobe(kind, a, l, v);
}

}  // namespace pentimento

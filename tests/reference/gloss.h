#pragma once
// The twin of optics/gloss_table.h: every pixel of a light probe through the model's own lobe.

#include <algorithm>
#include <array>
#include <cmath>

#include "core/optics/irradiance.h"
#include "core/optics/lighting.h"
#include "core/optics/microfacet.h"

namespace pentimento::reference {

using Rgb = std::array<double, 3>;

/// `v` in a frame whose z is the unit normal `n`; which tangents does not matter to the lobe.
inline Rgb in_frame(const Rgb& n, const Rgb& v) {
  const bool steep = std::abs(n[0]) > 0.9;
  const Rgb helper = steep ? Rgb{0, 1, 0} : Rgb{1, 0, 0};
  const auto dot = [](const Rgb& a, const Rgb& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const double along = dot(helper, n);
  Rgb t = {helper[0] - along * n[0], helper[1] - along * n[1], helper[2] - along * n[2]};
  const double length = std::sqrt(dot(t, t));
  for (double& x : t) x /= length;
  const Rgb b = {n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]};
  return {dot(t, v), dot(b, v), dot(n, v)};
}

/// int L f n.l dl / int f n.l dl with Torrance and Sparrow's f, v = (0,0,1).
inline Rgb mean_over_lobe(const LightProbe& probe, const Rgb& n, double roughness, double index) {
  constexpr double kPi = 3.14159265358979323846;
  const int width = probe[0].width(), height = probe[0].height();
  const Rgb v = in_frame(n, {0, 0, 1});
  Rgb sum{};
  double total = 0;
  for (int y = 0; y < height; ++y) {
    const double area =
        2 * kPi / width * (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height));
    for (int x = 0; x < width; ++x) {
      const Rgb l = in_frame(n, panorama_direction((x + 0.5) / width, (y + 0.5) / height));
      if (l[2] <= 0) continue;
      const double weight =
          area * l[2] * torrance_sparrow(FacetDistribution::kBeckmann, roughness, index, l, v);
      total += weight;
      for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * static_cast<double>(probe[c](x, y));
    }
  }
  for (double& x : sum) x /= total;
  return sum;
}

}  // namespace pentimento::reference

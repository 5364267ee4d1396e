// Light probes from files of each kind, as nine coefficients against all of their light.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/optics/irradiance.h"
#include "formats/image/read_image.h"
#include "formats/image/resample.h"

namespace pentimento {
namespace {

using Planes = std::array<Field<float>, 3>;
constexpr double kPi = 3.14159265358979323846;

/// Reduced to 128 x 64, so that every pixel can light every normal.
Planes probe(const std::string& name) {
  auto rgb = read_rgb(std::string(PENTIMENTO_SOURCE_DIR) + "/tests/data/probes/" + name);
  EXPECT_TRUE(rgb) << rgb.error().message;
  Planes small;
  for (std::size_t c = 0; rgb && c < 3; ++c) {
    small[c] = resample_area((*rgb)[c].view(), 128, 64);
  }
  return small;
}

/// By its definition: the sum over all pixels of L max(n.d, 0) times the pixel's solid angle.
double brute_force(const Field<float>& L, const std::array<double, 3>& n) {
  double sum = 0;
  for (int y = 0; y < L.height(); ++y) {
    const double area = 2 * kPi / L.width() *
                        (std::cos(kPi * y / L.height()) - std::cos(kPi * (y + 1) / L.height()));
    for (int x = 0; x < L.width(); ++x) {
      const auto d = panorama_direction((x + 0.5) / L.width(), (y + 0.5) / L.height());
      const double cosine = n[0] * d[0] + n[1] * d[1] + n[2] * d[2];
      sum += static_cast<double>(L(x, y)) * std::max(cosine, 0.0) * area;
    }
  }
  return sum;
}

/// Mean over normals spread evenly over the sphere (Fibonacci's spiral) of |E_9 - E|, against the
/// mean of E; of the green light.
double mean_error(const Planes& rgb) {
  const ShCoefficients nine = project_panorama({rgb[0].view(), rgb[1].view(), rgb[2].view()});
  constexpr int kNormals = 200;
  double error = 0, total = 0;
  for (int i = 0; i < kNormals; ++i) {
    const double z = 1 - (2 * i + 1.0) / kNormals, turn = i * kPi * (3 - std::sqrt(5.0));
    const double level = std::sqrt(1 - z * z);
    const std::array<double, 3> n = {level * std::cos(turn), level * std::sin(turn), z};
    const double exact = brute_force(rgb[1], n);
    const auto E = sh_irradiance(
        nine, {static_cast<float>(n[0]), static_cast<float>(n[1]), static_cast<float>(n[2])});
    error += std::abs(static_cast<double>(E[1]) - exact);
    total += exact;
  }
  return error / total;
}

TEST(LightProbe, NineCoefficientsAreASunsetsIrradianceToAPercent) {
  // 1 %: what Ramamoorthi and Hanrahan 2001 report for the probes that they measured.
  EXPECT_LT(mean_error(probe("sunset.exr")), 0.01);  // OpenEXR, DWAB
}

// The 1 % is not met where light comes from few small sources: nine numbers do not hold more. Of
// one point of light the mean error is 0.092 of the mean (by hand); the probes lie below it.
TEST(LightProbe, NineCoefficientsMissAPercentWhereSourcesAreSmall) {
  EXPECT_LT(mean_error(probe("studio.hdr")), 0.092);  // Radiance RGBE; 0.022 measured
  EXPECT_LT(mean_error(probe("city.exr")), 0.092);    // 0.039
  EXPECT_LT(mean_error(probe("studio.exr")), 0.092);  // 0.067
}

}  // namespace
}  // namespace pentimento

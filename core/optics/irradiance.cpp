#include "core/optics/irradiance.h"

#include <algorithm>
#include <numbers>

#include "core/base/approx.h"
#include "core/base/check.h"

namespace pentimento {
namespace {
/// What a clamped cosine does to the bands of order 0, 1 and 2.
constexpr std::array<double, 9> kCosineLobe = {
    std::numbers::pi,         2 * std::numbers::pi / 3, 2 * std::numbers::pi / 3,
    2 * std::numbers::pi / 3, std::numbers::pi / 4,     std::numbers::pi / 4,
    std::numbers::pi / 4,     std::numbers::pi / 4,     std::numbers::pi / 4};

std::array<float, 3> evaluate(const ShCoefficients& light, std::array<float, 3> direction,
                              const std::array<double, 9>& weight) {
  const std::array<double, 9> Y = sh_basis({direction[0], direction[1], direction[2]});
  std::array<float, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0;
    for (std::size_t i = 0; i < 9; ++i)
      sum += weight[i] * static_cast<double>(light.L[i][c]) * Y[i];
    out[c] = static_cast<float>(std::max(sum, 0.0));
  }
  return out;
}

}  // namespace

std::array<double, 9> sh_basis(std::array<double, 3> d) {
  const auto [x, y, z] = d;
  constexpr double k1 = 0.4886025119029199, k2 = 1.0925484305920792;
  return {0.28209479177387814,
          k1 * y,
          k1 * z,
          k1 * x,
          k2 * x * y,
          k2 * y * z,
          0.31539156525252005 * (3 * z * z - 1),
          k2 * x * z,
          0.5462742152960396 * (x * x - y * y)};
}

std::array<float, 3> sh_irradiance(const ShCoefficients& light, std::array<float, 3> n) {
  return evaluate(light, n, kCosineLobe);
}

std::array<float, 3> sh_radiance(const ShCoefficients& light, std::array<float, 3> d) {
  return evaluate(light, d, {1, 1, 1, 1, 1, 1, 1, 1, 1});
}

std::array<double, 3> panorama_direction(double u, double v) {
  const double longitude = 2 * std::numbers::pi * (u - 0.5),
               latitude = std::numbers::pi * (0.5 - v);
  const double level = approx::cos(latitude);
  return {-level * approx::sin(longitude), approx::sin(latitude), level * approx::cos(longitude)};
}

ShCoefficients project_panorama(const std::array<FieldView<const float>, 3>& rgb) {
  const int width = rgb[0].width(), height = rgb[0].height();
  PENTIMENTO_CHECK(width > 0 && height > 0);
  std::array<std::array<double, 3>, 9> sum{};
  for (int y = 0; y < height; ++y) {
    // Area of a pixel of this row on the unit sphere: the zone between its two latitudes.
    const double top = approx::sin(std::numbers::pi * (0.5 - static_cast<double>(y) / height));
    const double bottom =
        approx::sin(std::numbers::pi * (0.5 - static_cast<double>(y + 1) / height));
    const double solid_angle = 2 * std::numbers::pi / width * (top - bottom);
    for (int x = 0; x < width; ++x) {
      const auto Y = sh_basis(panorama_direction((x + 0.5) / width, (y + 0.5) / height));
      for (std::size_t i = 0; i < 9; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
          sum[i][c] += static_cast<double>(rgb[c](x, y)) * Y[i] * solid_angle;
        }
      }
    }
  }
  ShCoefficients out;
  for (std::size_t i = 0; i < 9; ++i) {
    for (std::size_t c = 0; c < 3; ++c) out.L[i][c] = static_cast<float>(sum[i][c]);
  }
  return out;
}

}  // namespace pentimento

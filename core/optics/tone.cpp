#include "core/optics/tone.h"

#include <Eigen/Dense>
#include <algorithm>
#include <iterator>

namespace pentimento {
namespace {

constexpr std::string_view kNames[] = {"none", "soft", "filmic"};

Eigen::Vector3d xyz_of(std::array<float, 2> xy) {
  const double x = static_cast<double>(xy[0]), y = static_cast<double>(xy[1]);
  return {x / y, 1, (1 - x - y) / y};
}

}  // namespace

std::string_view tone_curve_name(ToneCurve curve) {
  return kNames[static_cast<std::size_t>(curve)];
}

std::optional<ToneCurve> tone_curve_of(std::string_view name) {
  const auto* found = std::find(std::begin(kNames), std::end(kNames), name);
  if (found == std::end(kNames)) return std::nullopt;
  return static_cast<ToneCurve>(found - std::begin(kNames));
}

float tone(ToneCurve curve, float x) {
  constexpr float kKnee = 0.7f, kRest = 1 - kKnee;
  switch (curve) {
    case ToneCurve::kNone:
      return x;
    case ToneCurve::kSoft:
      return x <= kKnee ? x : 1 - kRest / (1 + (x - kKnee) / kRest);
    case ToneCurve::kFilmic:
      return std::min(x * (2.51f * x + 0.03f) / (x * (2.43f * x + 0.59f) + 0.14f), 1.0f);
  }
  return x;
}

std::array<std::array<float, 3>, 3> white_balance(std::array<float, 2> white_xy) {
  std::array<std::array<float, 3>, 3> out{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  if (white_xy == kD65_xy) return out;
  Eigen::Matrix3d bradford, srgb;
  bradford << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
  srgb << 0.4123908, 0.3575843, 0.1804808, 0.2126390, 0.7151687, 0.0721923, 0.0193308, 0.1191948,
      0.9505322;
  const Eigen::Vector3d from = bradford * xyz_of(white_xy), to = bradford * xyz_of(kD65_xy);
  const Eigen::Vector3d gain = to.cwiseQuotient(from);
  const Eigen::Matrix3d whole =
      srgb.inverse() * bradford.inverse() * gain.asDiagonal() * bradford * srgb;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      out[i][j] =
          static_cast<float>(whole(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
  return out;
}

std::array<float, 2> white_of_temperature(double kelvin) {
  const double t = 1e3 / kelvin;
  double x = 0, y = 0;
  if (kelvin >= 4000) {
    x = kelvin <= 7000 ? ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063
                       : ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040;
    y = (-3 * x + 2.870) * x - 0.275;
  } else {
    x = ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910;
    y = kelvin < 2222 ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                      : ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
  }
  return {static_cast<float>(x), static_cast<float>(y)};
}

}  // namespace pentimento

#include "replay/compare/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/check.h"
#include "replay/compare/convolve.h"
#include "replay/compare/flip_color.h"

namespace pentimento {

namespace {

using flip::ColorTriple;
using ColorPlanes = std::array<Field<float>, 3>;

// The paper's constants.
constexpr double kColorExponent = 0.7;    // q_c
constexpr double kColorKnee = 0.4;        // p_c: share of the largest difference ...
constexpr double kColorKneeError = 0.95;  // p_t: ... that becomes this error
constexpr double kFeatureExponent = 0.5;  // q_f
constexpr double kFeatureWidth_deg = 0.082;

/// Contrast sensitivity of one opponent channel, in space: a sum of two Gaussians
/// a sqrt(pi/b) exp(-pi^2 r^2 / b), r in degrees (the paper's table 1).
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr Sensitivity kAchromatic = {1.0, 0.0047, 0.0, 1e-5};
constexpr Sensitivity kRedGreen = {1.0, 0.0053, 0.0, 1e-5};
constexpr Sensitivity kBlueYellow = {34.1, 0.04, 13.5, 0.025};
constexpr double kWidest_deg2 = 0.04;  // largest b: sets the radius of all three

double sum_of(const Taps& taps) {
  double sum = 0;
  for (const double t : taps) sum += t;
  return sum;
}

/// exp(-pi^2 x^2 / b) on the pixel grid, and its sum.
Taps gaussian(double b, int radius, double ppd) {
  Taps taps;
  for (int i = -radius; i <= radius; ++i) {
    const double x_deg = i / ppd;
    taps.push_back(std::exp(-std::numbers::pi * std::numbers::pi * x_deg * x_deg / b));
  }
  return taps;
}

void scale(Taps& taps, double factor) {
  for (double& t : taps) t *= factor;
}

/// One opponent channel as the eye resolves it. Each Gaussian is separable; their weighted sum is
/// normalised as a whole.
Field<float> filtered(FieldView<const float> in, const Sensitivity& s, double ppd,
                      const Threads& threads) {
  const double pi = std::numbers::pi;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(kWidest_deg2 / (2 * pi * pi)) * ppd));
  Taps first = gaussian(s.b1, radius, ppd), second = gaussian(s.b2, radius, ppd);
  const double first_sum = sum_of(first), second_sum = sum_of(second);
  const double w1 = s.a1 * std::sqrt(pi / s.b1), w2 = s.a2 * std::sqrt(pi / s.b2);
  const double total = w1 * first_sum * first_sum + w2 * second_sum * second_sum;
  Taps down = first;
  scale(down, w1 / total);
  Field<float> out = convolve(in, first, down, threads);
  if (s.a2 == 0) return out;
  down = second;
  scale(down, w2 / total);
  const Field<float> more = convolve(in, second, down, threads);
  for (int y = 0; y < out.height(); ++y)
    for (int x = 0; x < out.width(); ++x) out(x, y) += more(x, y);
  return out;
}

ColorPlanes opponent_planes(const RgbPlanes& rgb, const Threads& threads) {
  ColorPlanes out;
  const int width = rgb[0].width(), height = rgb[0].height();
  for (Field<float>& plane : out) plane = Field<float>(width, height);
  threads.for_rows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      ColorTriple c{};
      for (std::size_t i = 0; i < 3; ++i)
        c[i] = static_cast<double>(std::clamp(rgb[i](x, y), 0.0f, 1.0f));
      c = flip::ycxcz_of_rgb(c);
      for (std::size_t i = 0; i < 3; ++i) out[i](x, y) = static_cast<float>(c[i]);
    }
  });
  return out;
}

/// The filtered picture's colour, as differences are measured in.
ColorTriple seen_color(const ColorPlanes& planes, int x, int y) {
  ColorTriple rgb = flip::rgb_of_ycxcz({static_cast<double>(planes[0](x, y)),
                                        static_cast<double>(planes[1](x, y)),
                                        static_cast<double>(planes[2](x, y))});
  for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
  return flip::hunt_lab_of_rgb(rgb);
}

/// The colour difference squeezed into 0..1: most of the range for small ones.
double color_error(const ColorTriple& a, const ColorTriple& b) {
  static const double largest =
      std::pow(flip::hyab(flip::hunt_lab_of_rgb({0, 1, 0}), flip::hunt_lab_of_rgb({0, 0, 1})),
               kColorExponent);
  const double error = std::pow(flip::hyab(a, b), kColorExponent);
  const double knee = kColorKnee * largest;
  if (error < knee) return error * kColorKneeError / knee;
  return kColorKneeError + (error - knee) / (largest - knee) * (1 - kColorKneeError);
}

/// First (edges) or second (points) derivative of a Gaussian, positive and negative weights each
/// scaled to a sum of 1 over the plane; `smooth` is the Gaussian across it, scaled to 1.
struct Detector {
  Taps derivative, smooth;
};

Detector make_detector(bool points, double ppd) {
  const double sd = 0.5 * kFeatureWidth_deg * ppd;
  const int radius = static_cast<int>(std::ceil(3 * sd));
  Detector detector;
  double positive = 0, negative = 0;
  for (int i = -radius; i <= radius; ++i) {
    const double g = std::exp(-i * i / (2 * sd * sd));
    const double d = points ? (i * i / (sd * sd) - 1) * g : -i * g;
    detector.smooth.push_back(g);
    detector.derivative.push_back(d);
    (d > 0 ? positive : negative) += std::abs(d);
  }
  for (double& d : detector.derivative) d /= d > 0 ? positive : negative;
  scale(detector.smooth, 1 / sum_of(detector.smooth));
  return detector;
}

/// Size of the feature at each pixel, for a luma in 0..1.
Field<float> feature_map(FieldView<const float> luma, const Detector& detector,
                         const Threads& threads) {
  Field<float> across = convolve(luma, detector.derivative, detector.smooth, threads);
  const Field<float> down = convolve(luma, detector.smooth, detector.derivative, threads);
  for (int y = 0; y < across.height(); ++y)
    for (int x = 0; x < across.width(); ++x)
      across(x, y) = std::sqrt(across(x, y) * across(x, y) + down(x, y) * down(x, y));
  return across;
}

/// |edges or points of one - those of the other|, whichever is larger.
Field<float> feature_difference(const Field<float>& reference, const Field<float>& test, double ppd,
                                const Threads& threads) {
  Field<float> largest(reference.width(), reference.height());
  for (const bool points : {false, true}) {
    const Detector detector = make_detector(points, ppd);
    const Field<float> a = feature_map(reference.view(), detector, threads);
    const Field<float> b = feature_map(test.view(), detector, threads);
    for (int y = 0; y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        largest(x, y) = std::max(largest(x, y), std::abs(a(x, y) - b(x, y)));
  }
  return largest;
}

Field<float> luma_of(const ColorPlanes& opponent) {
  Field<float> luma(opponent[0].width(), opponent[0].height());
  for (int y = 0; y < luma.height(); ++y)
    for (int x = 0; x < luma.width(); ++x) luma(x, y) = (opponent[0](x, y) + 16) / 116;
  return luma;
}

void filter_planes(ColorPlanes& planes, double ppd, const Threads& threads) {
  const std::array<Sensitivity, 3> sensitivities = {kAchromatic, kRedGreen, kBlueYellow};
  for (std::size_t i = 0; i < 3; ++i)
    planes[i] = filtered(planes[i].view(), sensitivities[i], ppd, threads);
}

}  // namespace

Field<float> flip_map(const RgbPlanes& reference, const RgbPlanes& test, double pixels_per_degree,
                      const Threads& threads) {
  const int width = reference[0].width(), height = reference[0].height();
  PENTIMENTO_CHECK(test[0].width() == width && test[0].height() == height);
  ColorPlanes a = opponent_planes(reference, threads);
  ColorPlanes b = opponent_planes(test, threads);
  const Field<float> features =
      feature_difference(luma_of(a), luma_of(b), pixels_per_degree, threads);
  filter_planes(a, pixels_per_degree, threads);
  filter_planes(b, pixels_per_degree, threads);
  Field<float> out(width, height);
  threads.for_rows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const double color = color_error(seen_color(a, x, y), seen_color(b, x, y));
      const double feature =
          std::pow(static_cast<double>(features(x, y)) / std::numbers::sqrt2, kFeatureExponent);
      out(x, y) = static_cast<float>(std::min(1.0, std::pow(color, 1 - feature)));
    }
  });
  return out;
}

}  // namespace pentimento

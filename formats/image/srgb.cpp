#include "formats/image/srgb.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace pentimento {

namespace {

constexpr double kLinearCode = 0.04045;     // below it the curve is a straight line
constexpr double kLinearLight = 0.0031308;  // the same point in light
constexpr double kSlope = 12.92;
constexpr double kOffset = 0.055;

/// x^(1/n) for x in (0,1], by Newton's method from above, where it falls monotonically.
double root(double x, int n) {
  double y = 1;
  for (int i = 0; i < 200; ++i) {
    double power = 1;
    for (int k = 1; k < n; ++k) power *= y;
    const double next = ((n - 1) * y + x / power) / n;
    if (next >= y) break;
    y = next;
  }
  return y;
}

}  // namespace

double srgb_to_linear(double v) {
  if (v <= kLinearCode) return v / kSlope;
  const double x = (v + kOffset) / (1 + kOffset);
  return x * x * root(x * x, 5);  // x^2.4
}

double linear_to_srgb(double v) {
  if (v <= kLinearLight) return v * kSlope;
  const double x12 = root(std::sqrt(std::sqrt(v)), 3);  // v^(1/12)
  const double x24 = x12 * x12;
  return (1 + kOffset) * (x24 * x24 * x12) - kOffset;  // v^(5/12)
}

SrgbEncoder::SrgbEncoder(int max_code)
    : max_code_(max_code), threshold_(static_cast<std::size_t>(max_code) + 2) {
  threshold_[0] = 0;
  for (int c = 1; c <= max_code; ++c) {
    const double edge = srgb_to_linear((c - 0.5) / max_code);
    float t = static_cast<float>(edge);
    if (static_cast<double>(t) < edge) t = std::nextafterf(t, 2.0f);
    threshold_[static_cast<std::size_t>(c)] = t;
  }
  threshold_[static_cast<std::size_t>(max_code) + 1] = std::numeric_limits<float>::infinity();
  const std::uint32_t buckets = ((kOneBits - kFirstBits) >> kBucketShift) + 1;
  for (std::uint32_t i = 0; i < buckets; ++i) {
    const float low = std::bit_cast<float>(kFirstBits + (i << kBucketShift));
    const auto above = std::upper_bound(threshold_.begin(), threshold_.end(), low);
    start_.push_back(static_cast<std::uint32_t>(above - threshold_.begin()) - 1);
  }
}

}  // namespace pentimento

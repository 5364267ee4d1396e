#include "replay/compare/plane_difference.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentimento {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// 0 for equal values, two NaN included; infinite where only one is finite.
template <typename T>
double distance(T a, T b) {
  const double x = static_cast<double>(a), y = static_cast<double>(b);
  if (x == y || (std::isnan(x) && std::isnan(y))) return 0;
  return std::isfinite(x) && std::isfinite(y) ? std::abs(x - y) : kInfinite;
}

template <typename T>
PlaneDifference difference(const std::string& name, FieldView<const T> a, FieldView<const T> b,
                           double peak) {
  PlaneDifference d;
  d.name = name;
  d.values = std::int64_t{a.width()} * a.height();
  double squares = 0;
  std::int64_t differing = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const double v = distance(a(x, y), b(x, y));
      if (v == 0) continue;
      ++differing;
      squares += v * v;
      if (v <= d.max) continue;
      d.max = v;
      d.max_x = x;
      d.max_y = y;
    }
  const double count = static_cast<double>(d.values > 0 ? d.values : 1);
  d.rms = std::sqrt(squares / count);
  d.differing = static_cast<double>(differing) / count;
  d.psnr_db = d.rms == 0 ? kInfinite : 20 * std::log10(peak / d.rms);
  return d;
}

}  // namespace

PlaneDifference plane_difference(const std::string& name, FieldView<const float> a,
                                 FieldView<const float> b, double peak) {
  return difference(name, a, b, peak);
}

PlaneDifference plane_difference(const std::string& name, FieldView<const std::uint32_t> a,
                                 FieldView<const std::uint32_t> b, double peak) {
  return difference(name, a, b, peak);
}

PlaneDifference fidelity(const std::string& name, FieldView<const float> a,
                         FieldView<const float> b) {
  const double peak = largest_value(a);
  PlaneDifference d = plane_difference(name, a, b, peak);
  double squares = 0, worst = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const double value = static_cast<double>(a(x, y));
      squares += value * value;
      const double v = distance(a(x, y), b(x, y));
      if (v > 0) worst = std::max(worst, v / std::max(std::abs(value), 1e-3 * peak));
    }
  d.relative_l2 = d.rms == 0 ? 0 : d.rms * std::sqrt(static_cast<double>(d.values) / squares);
  d.worst_block = worst;
  return d;
}

double largest_value(FieldView<const float> plane) {
  double largest = 0;
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x) {
      const double v = std::abs(static_cast<double>(plane(x, y)));
      if (std::isfinite(v) && v > largest) largest = v;
    }
  return largest;
}

}  // namespace pentimento

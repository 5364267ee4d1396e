#include "formats/log/edit/spline_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/brush/centripetal_spline.h"
#include "formats/log/edit/resample.h"

namespace pentimento::log {

namespace {
/// Samples nearer than this are one place, as for the painter: a pause.
constexpr double kSamePlace_m = 1e-9;

SplinePoint place_of(const TimedTouch& sample) {
  return {sample.touch.x_m, sample.touch.y_m};
}
double distance(const SplinePoint& a, const SplinePoint& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}
SplinePoint reflected(const SplinePoint& centre, const SplinePoint& point) {
  return {2 * centre.x - point.x, 2 * centre.y - point.y};
}

/// By how many tolerances two values differ; endless if only one is there.
double excess(const std::optional<double>& a, const std::optional<double>& b, double tolerance) {
  if (!a && !b) return 0;
  return a && b ? std::abs(*a - *b) / tolerance : INFINITY;
}

/// The parameter near `begin` at which the curve comes nearest to the place: Newton's steps along
/// the tangent.
double nearest(const SplineSegment& curve, const SplinePoint& place, double begin) {
  constexpr int kSteps = 4;
  double u = begin;
  for (int i = 0; i < kSteps; ++i) {
    const SplinePoint at = curve.at(u), slope = curve.slope(u);
    const double length2 = slope.x * slope.x + slope.y * slope.y;
    if (!(length2 > 0)) break;
    u += ((place.x - at.x) * slope.x + (place.y - at.y) * slope.y) / length2;
    u = std::clamp(u, 0.0, 1.0);
  }
  return u;
}

class Fit {
 public:
  Fit(std::vector<TimedTouch>& samples, const SplineTolerance& tolerance)
      : samples_(samples), tolerance_(tolerance) {}

  void run() {
    if (samples_.empty()) return;
    samples_.front().keep = samples_.back().keep = true;
    while (add_worst()) {
    }
  }

 private:
  /// Keeps the worst sample of each piece that is too far from the curve. Returns whether any is.
  bool add_worst() {
    kept_.clear();
    for (std::size_t i = 0; i < samples_.size(); ++i)
      if (samples_[i].keep) kept_.push_back(i);
    bool added = false;
    for (std::size_t k = 0; k + 1 < kept_.size(); ++k) added |= add_worst_of(k);
    return added;
  }

  bool add_worst_of(std::size_t k) {
    if (kept_[k + 1] == kept_[k] + 1) return false;
    const std::optional<SplineSegment> curve = curve_of(k);
    double worst = 1;
    std::size_t at = 0;
    for (std::size_t i = kept_[k] + 1; i < kept_[k + 1]; ++i) {
      const double error = error_of(i, samples_[kept_[k]], samples_[kept_[k + 1]], curve);
      if (error <= worst) continue;
      worst = error;
      at = i;
    }
    if (at > 0) samples_[at].keep = true;
    return at > 0;
  }

  /// Between two kept samples; nothing if they are at one place.
  std::optional<SplineSegment> curve_of(std::size_t k) const {
    const SplinePoint p1 = place_of(samples_[kept_[k]]), p2 = place_of(samples_[kept_[k + 1]]);
    if (distance(p1, p2) < kSamePlace_m) return {};
    SplinePoint p0 = reflected(p1, p2), p3 = reflected(p2, p1);
    for (std::size_t i = k; i-- > 0;) {
      if (distance(place_of(samples_[kept_[i]]), p1) < kSamePlace_m) continue;
      p0 = place_of(samples_[kept_[i]]);
      break;
    }
    for (std::size_t i = k + 2; i < kept_.size(); ++i) {
      if (distance(place_of(samples_[kept_[i]]), p2) < kSamePlace_m) continue;
      p3 = place_of(samples_[kept_[i]]);
      break;
    }
    return spline_segment(p0, p1, p2, p3);
  }

  /// How far the painter's curve is from the sample, in tolerances: where it comes nearest.
  double error_of(std::size_t i, const TimedTouch& from, const TimedTouch& to,
                  const std::optional<SplineSegment>& curve) const {
    const TimedTouch& sample = samples_[i];
    const auto span = static_cast<double>(to.time_us - from.time_us);
    const double by_time = span > 0 ? static_cast<double>(sample.time_us - from.time_us) / span : 0;
    const double u = curve ? nearest(*curve, place_of(sample), by_time) : by_time;
    const SplinePoint place = curve ? curve->at(u) : place_of(from);
    const Touch even = between(from.touch, to.touch, u);
    return std::max({distance(place, place_of(sample)) / tolerance_.place_m,
                     std::abs(u - by_time) * span * 1e-6 / tolerance_.time_s,
                     excess(even.radius_m, sample.touch.radius_m, tolerance_.place_m),
                     excess(even.pressure, sample.touch.pressure, tolerance_.pressure),
                     excess(even.tilt_x_deg, sample.touch.tilt_x_deg, tolerance_.angle_deg),
                     excess(even.tilt_y_deg, sample.touch.tilt_y_deg, tolerance_.angle_deg),
                     excess(even.twist_deg, sample.touch.twist_deg, tolerance_.angle_deg)});
  }

  std::vector<TimedTouch>& samples_;
  SplineTolerance tolerance_;
  std::vector<std::size_t> kept_;
};
}  // namespace

void keep_for_spline(std::vector<TimedTouch>& samples, const SplineTolerance& tolerance) {
  Fit(samples, tolerance).run();
}

}  // namespace pentimento::log

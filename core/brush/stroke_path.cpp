#include "core/brush/stroke_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/check.h"

namespace pentimento {

namespace {
constexpr double kPauseFrac = 1e-4;    // of the diameter: smaller moves are the hand's tremble
constexpr double kTapFrac = 0.5;       // of the diameter: a tap deposits as much
constexpr int kDabStamps = 12;         // of a tap, evenly around
constexpr double kHeadingFrac = 0.25;  // of the diameter: length over which a tip turns
constexpr double kChordsPerStamp = 4;  // a chord's sagitta is then far below a cell
constexpr int kMinChords = 4;
constexpr int kMaxChords = 4096;
constexpr double kFarthest = 1000;      // canvas sizes: what is farther away is taken to be there
constexpr double kShortestTime = 1e-3;  // between samples: devices deliver several at one time

double length(double x, double y) {
  return std::sqrt(x * x + y * y);
}
float mix(float a, float b, float u) {
  return a + (b - a) * u;
}
float mix_pressure(float a, float b, float u) {
  if (a < 0) return b;
  return b < 0 ? a : mix(a, b, u);
}
float mix_angle(float a, float b, float u) {
  constexpr float kPi = 3.14159265f;
  float turn = b - a;
  if (turn > kPi) turn -= 2 * kPi;
  if (turn < -kPi) turn += 2 * kPi;
  return a + turn * u;
}

/// Interpolates a sample along a segment: all of it but the place.
Stamp stamp_between(const TouchSample& from, const TouchSample& to, double at) {
  const float u = static_cast<float>(at);
  Stamp s;
  s.time_s = from.time_s + (to.time_s - from.time_s) * at;
  s.diameter_m = mix(from.diameter_m, to.diameter_m, u);
  s.pressure = mix_pressure(from.pressure, to.pressure, u);
  s.tilt_x_rad = mix(from.tilt_x_rad, to.tilt_x_rad, u);
  s.tilt_y_rad = mix(from.tilt_y_rad, to.tilt_y_rad, u);
  s.twist_rad = mix_angle(from.twist_rad, to.twist_rad, u);
  return s;
}
}  // namespace

StrokePath::StrokePath(double spacing_frac, double width_m, double height_m)
    : spacing_frac_(spacing_frac), width_m_(width_m), height_m_(height_m) {
  PENTIMENTO_CHECK(spacing_frac > 0 && width_m > 0 && height_m > 0);
}

void StrokePath::set_spacing(double spacing_frac) {
  PENTIMENTO_CHECK(spacing_frac > 0);
  spacing_frac_ = spacing_frac;
}

TouchSample StrokePath::within_reach(TouchSample sample) const {
  PENTIMENTO_CHECK(sample.diameter_m > 0 && std::isfinite(sample.x_m) && std::isfinite(sample.y_m));
  sample.x_m = std::clamp(sample.x_m, -kFarthest * width_m_, kFarthest * width_m_);
  sample.y_m = std::clamp(sample.y_m, -kFarthest * height_m_, kFarthest * height_m_);
  return sample;
}

void StrokePath::begin(const TouchSample& device_sample) {
  const TouchSample sample = within_reach(device_sample);
  knots_ = 1;
  knot_[2] = {sample, sample};
  progress_ = travel_m_ = total_m_ = 0;
  final_until_s_ = sample.time_s;
  heading_ = {};
}

void StrokePath::add(const TouchSample& device_sample, std::vector<Stamp>& out) {
  PENTIMENTO_CHECK(knots_ > 0);
  const TouchSample sample = within_reach(device_sample);
  Knot& end = knot_[2];
  const double dx = sample.x_m - end.arrive.x_m;
  const double dy = sample.y_m - end.arrive.y_m;
  if (length(dx, dy) < kPauseFrac * sample.diameter_m) {
    const TouchSample place = end.arrive;
    end.leave = sample;
    end.leave.x_m = place.x_m;
    end.leave.y_m = place.y_m;
    return;
  }
  if (knots_ >= 2) run(pending_segment({sample.x_m, sample.y_m}), out);
  knot_[0] = knot_[1];
  knot_[1] = knot_[2];
  knot_[2] = {sample, sample};
  knots_ = std::min(knots_ + 1, 3);
}

void StrokePath::finish(std::vector<Stamp>& out) {
  PENTIMENTO_CHECK(knots_ > 0);
  const TouchSample& b = knot_[2].arrive;
  Stamp last = stamp_between(b, knot_[2].leave, 1.0);
  if (knots_ >= 2) {
    const TouchSample& a = knot_[1].leave;
    const Segment segment = pending_segment({2 * b.x_m - a.x_m, 2 * b.y_m - a.y_m});
    run(segment, out);
    const Point m1 = segment.curve.end_slope();
    const double m = length(m1.x, m1.y);
    if (m > 0) last.direction = {static_cast<float>(m1.x / m), static_cast<float>(m1.y / m)};
  }
  const Span near = near_canvas({b.x_m, b.y_m}, {0, 0}, b.diameter_m);
  if (near.from <= near.to) {
    turn_heading(last.direction, travel_m_, b.diameter_m);
    last.x_m = b.x_m;
    last.y_m = b.y_m;
    last.heading = heading_;
    if (travel_m_ > kPauseFrac * b.diameter_m) {
      last.travel_m = static_cast<float>(travel_m_);
      out.push_back(last);
    }
    add_dab(last, kTapFrac * b.diameter_m - total_m_, out);
  }
  final_until_s_ = knot_[2].leave.time_s;
  knots_ = 0;
}

/// What a short touch lacks of a tap: the brush is pressed down where it is and spreads to all
/// sides.
void StrokePath::add_dab(Stamp stamp, double travel_m, std::vector<Stamp>& out) {
  if (!(travel_m > kPauseFrac * static_cast<double>(stamp.diameter_m))) return;
  constexpr float kHalf = 0.5f, kRoot = 0.8660254f;  // cosine and sine of 60 degrees
  constexpr Vec2f kAround[kDabStamps] = {
      {1, 0},  {kRoot, kHalf},   {kHalf, kRoot},   {0, 1},  {-kHalf, kRoot}, {-kRoot, kHalf},
      {-1, 0}, {-kRoot, -kHalf}, {-kHalf, -kRoot}, {0, -1}, {kHalf, -kRoot}, {kRoot, -kHalf}};
  stamp.direction = {};
  stamp.velocity_m_s = {};
  stamp.travel_m = static_cast<float>(travel_m / kDabStamps);
  for (const Vec2f& dab : kAround) {
    stamp.dab = dab;
    out.push_back(stamp);
  }
}

/// The piece between the last two knots, `p3` being the place after them.
StrokePath::Segment StrokePath::pending_segment(const Point& p3) const {
  Segment s;
  s.from = knot_[1].leave;
  s.to = knot_[2].arrive;
  const Point p1{s.from.x_m, s.from.y_m};
  const Point p2{s.to.x_m, s.to.y_m};
  const TouchSample& before = knot_[0].arrive;
  const Point p0 =
      knots_ == 3 ? Point{before.x_m, before.y_m} : Point{2 * p1.x - p2.x, 2 * p1.y - p2.y};
  s.curve = spline_segment(p0, p1, p2, p3);
  s.chord_m = length(p2.x - p1.x, p2.y - p1.y);
  return s;
}

/// Walks a segment in chords, short beside the distance of stamps.
void StrokePath::run(const Segment& segment, std::vector<Stamp>& out) {
  const double step_m = spacing_frac_ * std::min(segment.from.diameter_m, segment.to.diameter_m);
  const double wanted = kChordsPerStamp * segment.chord_m / step_m;
  const int chords =
      wanted >= kMaxChords ? kMaxChords : std::max(kMinChords, static_cast<int>(wanted) + 1);
  const bool is_far = misses_canvas(segment);
  Point a = segment.at(0);
  for (int i = 0; i < chords; ++i) {
    const double u0 = static_cast<double>(i) / chords;
    const double u1 = static_cast<double>(i + 1) / chords;
    const Point b = segment.at(u1);
    if (is_far) {
      pass_chord(length(b.x - a.x, b.y - a.y), step_between(segment, u0, u1));
    } else {
      run_chord(segment, u0, u1, a, b, out);
    }
    a = b;
  }
  final_until_s_ = segment.to.time_s;
}

double StrokePath::diameter_between(const Segment& segment, double u0, double u1) {
  return mix(segment.from.diameter_m, segment.to.diameter_m, static_cast<float>(0.5 * (u0 + u1)));
}

double StrokePath::step_between(const Segment& segment, double u0, double u1) const {
  return spacing_frac_ * diameter_between(segment, u0, u1);
}

/// Whether the tip is too far from the canvas on the whole segment. A curve lies in the hull of its
/// four control points; the margin is wide beside what rounding does to a chord.
bool StrokePath::misses_canvas(const Segment& segment) const {
  constexpr double kMargin = 1.001;
  const SplineSegment& c = segment.curve;
  const Point end = c.at(1), slope = c.end_slope();
  const double reach_m =
      kMargin * std::max(segment.from.diameter_m, segment.to.diameter_m) + kPauseFrac * width_m_;
  const auto misses = [&](double p0, double m0, double p3, double m3, double size) {
    const auto [low, high] = std::minmax({p0, p0 + m0 / 3, p3 - m3 / 3, p3});
    return high < -reach_m || low > size + reach_m;
  };
  return misses(c.start.x, c.m0.x, end.x, slope.x, width_m_) ||
         misses(c.start.y, c.m0.y, end.y, slope.y, height_m_);
}

/// Places the stamps of one straight piece. The part from which the tip cannot reach the canvas is
/// skipped at once, so a jump far outside costs no more than one across the canvas.
void StrokePath::run_chord(const Segment& segment, double u0, double u1, const Point& a,
                           const Point& b, std::vector<Stamp>& out) {
  const Point d{b.x - a.x, b.y - a.y};
  const double chord_m = length(d.x, d.y);
  if (!(chord_m > 0)) return;
  const double diameter_m = diameter_between(segment, u0, u1);
  const double step_m = step_between(segment, u0, u1);
  const Vec2f direction{static_cast<float>(d.x / chord_m), static_cast<float>(d.y / chord_m)};
  const double duration_s =
      std::max(kShortestTime, segment.to.time_s - segment.from.time_s) * (u1 - u0);
  const float speed = static_cast<float>(chord_m / duration_s);

  const Span near = near_canvas(a, d, diameter_m);
  double at_m = (1 - progress_) * step_m;
  double travel_m = travel_m_ + at_m;
  if (at_m < near.from * chord_m) {
    at_m += std::ceil((near.from * chord_m - at_m) / step_m) * step_m;
    travel_m = step_m;
  }
  for (; at_m <= near.to * chord_m; at_m += step_m, travel_m = step_m) {
    turn_heading(direction, travel_m, diameter_m);
    Stamp s = stamp_between(segment.from, segment.to, u0 + (u1 - u0) * (at_m / chord_m));
    s.x_m = a.x + d.x * (at_m / chord_m);
    s.y_m = a.y + d.y * (at_m / chord_m);
    s.direction = direction;
    s.heading = heading_;
    s.travel_m = static_cast<float>(travel_m);
    s.velocity_m_s = {direction.x * speed, direction.y * speed};
    out.push_back(s);
  }
  pass_chord(chord_m, step_m);
}

/// The brush moves on by a straight piece.
void StrokePath::pass_chord(double chord_m, double step_m) {
  if (!(chord_m > 0)) return;
  total_m_ += chord_m;
  const double ahead = progress_ + chord_m / step_m;
  progress_ = ahead - std::floor(ahead);
  travel_m_ = ahead < 1 ? travel_m_ + chord_m : progress_ * step_m;
}

/// The tip follows the line of travel, whichever way along it the brush is pulled.
void StrokePath::turn_heading(const Vec2f& direction, double travel_m, double diameter_m) {
  if (heading_.x == 0 && heading_.y == 0) {
    heading_ = direction;
    return;
  }
  const float along = heading_.x * direction.x + heading_.y * direction.y;
  const float sign = along < 0 ? -1.0f : 1.0f;
  const float k = static_cast<float>(travel_m / (travel_m + kHeadingFrac * diameter_m));
  const float x = heading_.x + k * (sign * direction.x - heading_.x);
  const float y = heading_.y + k * (sign * direction.y - heading_.y);
  const float norm = std::sqrt(x * x + y * y);
  if (norm > 0) heading_ = {x / norm, y / norm};
}

/// The share [from, to] of a -> a + d that is within `reach_m` of the canvas, empty if from > to.
StrokePath::Span StrokePath::near_canvas(const Point& a, const Point& d, double reach_m) const {
  Span span;
  const auto clip = [&](double at, double by, double size) {
    const double low = -reach_m - at;
    const double high = size + reach_m - at;
    if (by == 0) {
      if (low > 0 || high < 0) span = {2, -1};
      return;
    }
    span.from = std::max(span.from, std::min(low / by, high / by));
    span.to = std::min(span.to, std::max(low / by, high / by));
  };
  clip(a.x, d.x, width_m_);
  clip(a.y, d.y, height_m_);
  return span;
}

}  // namespace pentimento

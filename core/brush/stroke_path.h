#pragma once
// The path of one touch as a stream: the device's samples go in, evenly spaced stamps come out.
//   Curve: a centripetal spline through the samples (core/brush/centripetal_spline.h); the ends are
//   continued by reflection. Stamps: one each time the arc length grows by
//   `spacing` diameters; what is left over is carried from sample to sample, so that the stamps do
//   not depend on the device's rate.
// A segment is final once the sample after its end is known, so stamps come one sample late. The
// code uses only + - * / and sqrt, so the stamps are the same bits everywhere. Not thread-safe.

#include <vector>

#include "core/brush/centripetal_spline.h"
#include "core/brush/stamp.h"

namespace pentimento {

/// What the device measured at one moment, in the frame of Stamp.
struct TouchSample {
  double x_m = 0;
  double y_m = 0;
  double time_s = 0;
  float diameter_m = 0.03f;  // > 0, of the unpressed brush
  float pressure = -1;       // 0..1; negative = the device has none
  float tilt_x_rad = 0;
  float tilt_y_rad = 0;
  float twist_rad = 0;
};

class StrokePath {
 public:
  /// `spacing_frac`: way from stamp to stamp in diameters, > 0. Stamps whose tip cannot reach the
  /// canvas of width_m x height_m are left out, so a long way outside costs nothing.
  StrokePath(double spacing_frac, double width_m, double height_m);

  /// Changes the spacing from the next segment on.
  void set_spacing(double spacing_frac);

  /// The touch goes down at this sample.
  void begin(const TouchSample& device_sample);
  /// The touch moves. Appends to `out` the stamps that are final now. A move of less than 1e-4
  /// diameters is a pause: it changes pressure, tilt and time, not the path.
  void add(const TouchSample& device_sample, std::vector<Stamp>& out);
  /// The touch lifts. Appends the rest of the stamps to `out`. If the stroke was shorter than half
  /// a diameter, as a tap is, its last stamps deposit as much as half a diameter would: a dab
  /// (Stamp::dab).
  void finish(std::vector<Stamp>& out);

  /// All stamps before this time have come out, s.
  double final_until_s() const { return final_until_s_; }

 private:
  struct Knot {
    TouchSample arrive, leave;  // same place; they differ after a pause
  };
  using Point = SplinePoint;
  /// A piece of the path between two samples.
  struct Segment {
    TouchSample from, to;
    SplineSegment curve;
    double chord_m = 0;
    Point at(double u) const { return curve.at(u); }
  };

  struct Span {
    double from = 0, to = 1;
  };

  TouchSample within_reach(TouchSample sample) const;
  Segment pending_segment(const Point& p3) const;
  void run(const Segment& segment, std::vector<Stamp>& out);
  void run_chord(const Segment& segment, double u0, double u1, const Point& a, const Point& b,
                 std::vector<Stamp>& out);
  void pass_chord(double chord_m, double step_m);
  static double diameter_between(const Segment& segment, double u0, double u1);
  double step_between(const Segment& segment, double u0, double u1) const;
  bool misses_canvas(const Segment& segment) const;
  void add_dab(Stamp stamp, double travel_m, std::vector<Stamp>& out);
  void turn_heading(const Vec2f& direction, double travel_m, double diameter_m);
  Span near_canvas(const Point& a, const Point& d, double reach_m) const;

  double spacing_frac_;
  double width_m_;
  double height_m_;
  int knots_ = 0;        // how many of knot_ are set, the newest last
  Knot knot_[3];         // before the pending segment, its start, its end
  double progress_ = 0;  // towards the next stamp, [0,1)
  double travel_m_ = 0;  // since the last stamp
  double total_m_ = 0;   // since the touch went down
  double final_until_s_ = 0;
  Vec2f heading_;
};

}  // namespace pentimento

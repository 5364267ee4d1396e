#pragma once
// The curve of a stroke: centripetal Catmull-Rom through the samples of the device,
// t_{i+1} = t_i + |p_{i+1} - p_i|^(1/2), which neither loops nor overshoots between uneven samples
// (Yuksel, Schaefer, Keyser, CAD 43, 2011). Only + - * / and sqrt: the same bits everywhere.

#include <cmath>

namespace pentimento {

struct SplinePoint {
  double x = 0, y = 0;
};

/// A piece of the curve between two samples: start + u (m0 + u (c2 + u c3)), u in [0,1].
struct SplineSegment {
  SplinePoint start, m0, c2, c3;

  SplinePoint at(double u) const {
    return {start.x + u * (m0.x + u * (c2.x + u * c3.x)),
            start.y + u * (m0.y + u * (c2.y + u * c3.y))};
  }
  /// The derivative by u.
  SplinePoint slope(double u) const {
    return {m0.x + u * (2 * c2.x + 3 * u * c3.x), m0.y + u * (2 * c2.y + 3 * u * c3.y)};
  }
  /// That at the piece's end.
  SplinePoint end_slope() const { return {m0.x + 2 * c2.x + 3 * c3.x, m0.y + 2 * c2.y + 3 * c3.y}; }
};

/// The cubic from p1 to p2, p0 being the place before and p3 the one after; no two of them that
/// follow one another may be the same. Its end slopes are those of the non-uniform Catmull-Rom
/// spline: m = h12 [(p1-p0)/h01 - (p2-p0)/(h01+h12) + (p2-p1)/h12], h the knot distances.
inline SplineSegment spline_segment(const SplinePoint& p0, const SplinePoint& p1,
                                    const SplinePoint& p2, const SplinePoint& p3) {
  const auto knot_distance = [](const SplinePoint& a, const SplinePoint& b) {
    const double x = b.x - a.x, y = b.y - a.y;
    return std::sqrt(std::sqrt(x * x + y * y));
  };
  const double h01 = knot_distance(p0, p1);
  const double h12 = knot_distance(p1, p2);
  const double h23 = knot_distance(p2, p3);
  const auto start_slope = [&](double a, double b, double c) {
    return h12 * ((b - a) / h01 - (c - a) / (h01 + h12) + (c - b) / h12);
  };
  const auto end_slope = [&](double b, double c, double d) {
    return h12 * ((c - b) / h12 - (d - b) / (h12 + h23) + (d - c) / h23);
  };
  SplineSegment s;
  s.start = p1;
  s.m0 = {start_slope(p0.x, p1.x, p2.x), start_slope(p0.y, p1.y, p2.y)};
  const SplinePoint m1{end_slope(p1.x, p2.x, p3.x), end_slope(p1.y, p2.y, p3.y)};
  const SplinePoint d{p2.x - p1.x, p2.y - p1.y};
  s.c2 = {3 * d.x - 2 * s.m0.x - m1.x, 3 * d.y - 2 * s.m0.y - m1.y};
  s.c3 = {s.m0.x + m1.x - 2 * d.x, s.m0.y + m1.y - 2 * d.y};
  return s;
}

}  // namespace pentimento

#include "core/brush/centripetal_spline.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(CentripetalSpline, GoesFromSampleToSample) {
  const SplineSegment s = spline_segment({0, 0}, {1, 2}, {4, -1}, {5, 5});
  EXPECT_DOUBLE_EQ(s.at(0).x, 1);
  EXPECT_DOUBLE_EQ(s.at(0).y, 2);
  EXPECT_NEAR(s.at(1).x, 4, 1e-14);
  EXPECT_NEAR(s.at(1).y, -1, 1e-14);
}

TEST(CentripetalSpline, IsStraightAndEvenBetweenEvenSamplesOfALine) {
  const SplineSegment s = spline_segment({0, 0}, {1, 1}, {2, 2}, {3, 3});
  for (const double u : {0.25, 0.5, 0.75}) {
    EXPECT_NEAR(s.at(u).x, 1 + u, 1e-14);
    EXPECT_NEAR(s.at(u).y, 1 + u, 1e-14);
  }
}

// Neighbouring pieces have the same tangent, scaled by their knot distances: the curve has no
// corner.
TEST(CentripetalSpline, HasNoCorners) {
  const SplinePoint a{0, 0}, b{1, 0.2}, c{1.1, 1}, d{3, 1.5}, e{3, 4};
  const SplinePoint end = spline_segment(a, b, c, d).end_slope();
  const SplinePoint begin = spline_segment(b, c, d, e).m0;
  EXPECT_NEAR(end.x * begin.y - end.y * begin.x, 0, 1e-12);
  EXPECT_GT(end.x * begin.x + end.y * begin.y, 0);
  const auto h = [](const SplinePoint& p, const SplinePoint& q) {
    return std::sqrt(std::hypot(q.x - p.x, q.y - p.y));
  };
  EXPECT_NEAR(std::hypot(end.x, end.y) / h(b, c), std::hypot(begin.x, begin.y) / h(c, d), 1e-12);
}

}  // namespace
}  // namespace pentimento

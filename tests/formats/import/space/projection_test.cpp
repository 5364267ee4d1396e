#include "formats/import/space/projection.h"

#include <gtest/gtest.h>

#include <vector>

namespace pentimento::sketch {
namespace {

using Eigen::Vector3d;

/// Four corners of a rectangle 4 wide and 2 high: right, then up, from its middle.
std::vector<Vector3d> rectangle(const Vector3d& right, const Vector3d& up) {
  return {-2 * right - up, 2 * right - up, 2 * right + up, -2 * right + up};
}

void expect_seen(const std::vector<Vector3d>& corners, const PictureAxes& axes) {
  const double expected[4][2] = {{-2, 1}, {2, 1}, {2, -1}, {-2, -1}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(axes(corners[i]).x(), expected[i][0], 1e-9) << i;
    EXPECT_NEAR(axes(corners[i]).y(), expected[i][1], 1e-9) << i;
  }
}

TEST(Projection, SeesAPlaneFromTheViewersSideUpright) {
  const Vector3d x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  expect_seen(rectangle(x, y), best_plane(rectangle(x, y), z));
  // A viewer at -z has x on the left; one at x looks along -x, and has -z on the right.
  expect_seen(rectangle(-x, y), best_plane(rectangle(-x, y), -z));
  expect_seen(rectangle(-z, y), best_plane(rectangle(-z, y), x));
  const Vector3d slanting = Vector3d(1, 0, -1).normalized();
  expect_seen(rectangle(slanting, y), best_plane(rectangle(slanting, y), z));
  // What lies flat is seen from above, its far side up.
  expect_seen(rectangle(x, -z), best_plane(rectangle(x, -z), y));
}

TEST(Projection, WithoutPointsItIsThePlaneOfXAndY) {
  const PictureAxes axes = best_plane({}, Vector3d::UnitZ());
  EXPECT_EQ(axes(Vector3d(3, 4, 5)), Eigen::Vector2d(3, -4));
}

}  // namespace
}  // namespace pentimento::sketch

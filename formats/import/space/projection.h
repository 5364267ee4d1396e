#pragma once
// A 3-D sketch becomes a flat one: where each point lies as seen from far away. Pure functions.

#include <Eigen/Core>
#include <span>

namespace pentimento::sketch {

/// Where a point lies on the picture: x to the right, y DOWN, in the unit of the points.
struct PictureAxes {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();

  Eigen::Vector2d operator()(const Eigen::Vector3d& point) const {
    return {right.dot(point - centre), -up.dot(point - centre)};
  }
};

/// The plane that fits the points best: its normal is the direction of their least spread. It is
/// seen from the side of `viewer`, with `y` upwards where it can be; a plane that lies flat is seen
/// with -z upwards. Right-handed axes. No points: the plane of x and y.
PictureAxes best_plane(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& viewer);

}  // namespace pentimento::sketch

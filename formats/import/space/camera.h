#pragma once
// What a camera in space sees of strokes: places and widths on its picture, from back to front.

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formats/import/space/space_stroke.h"

namespace pentimento::sketch {

/// A pinhole camera; the axes are orthonormal and right-handed (forward = up x right).
struct PinholeCamera {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::UnitX();
  Eigen::Vector3d up = Eigen::Vector3d::UnitY();
  Eigen::Vector3d forward = -Eigen::Vector3d::UnitZ();
  double half_height = 1;  // of the picture: the tangent of half the field of view
  double aspect = 1;       // width over height of the picture
  double near = 0.1;       // nearer points are not seen, in the unit of the points

  double depth(const Eigen::Vector3d& point) const { return forward.dot(point - eye); }
  /// Picture coordinates, x right, y DOWN, as tangents. Only for points of positive depth.
  Eigen::Vector2d operator()(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from = point - eye;
    return Eigen::Vector2d{right.dot(from), -up.dot(from)} / forward.dot(from);
  }
  /// The whole picture.
  Page page() const {
    const double half_width = half_height * aspect;
    return {-half_width, -half_height, 2 * half_width, 2 * half_height};
  }
};

/// What a camera sees.
struct Sight {
  std::vector<Stroke> strokes;  // from the farthest to the nearest, by their mean depth; their
                                // times follow one another
  int unseen_points = 0;        // nearer than `near`, behind, or far beside the picture
  int merged_twins = 0;
};

/// The strokes as the camera sees them. A stroke that leaves the picture by more than half of its
/// size goes on as another where it comes back. A twin that lies within its width of the stroke
/// before it is left out. All strokes must be timed.
Sight see(std::span<const SpaceStroke> strokes, const PinholeCamera& camera);

/// Whether each point of `twin` is seen within a width of the same point of `partner`.
bool twin_is_hidden(const std::vector<Eigen::Vector2d>& twin,
                    const std::vector<Eigen::Vector2d>& partner, double width);

}  // namespace pentimento::sketch

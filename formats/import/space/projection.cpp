#include "formats/import/space/projection.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

namespace pentimento::sketch {

PictureAxes best_plane(std::span<const Eigen::Vector3d> points, const Eigen::Vector3d& viewer) {
  constexpr double kFlat = 0.9;  // of the normal along y: the plane lies flat
  PictureAxes out;
  if (points.empty()) return out;
  for (const Eigen::Vector3d& p : points) out.centre += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) spread += (p - out.centre) * (p - out.centre).transpose();
  // Eigenvalues rise: the first is that of the least spread.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  Eigen::Vector3d normal = axes.eigenvectors().col(0);
  if (normal.dot(viewer) < 0) normal = -normal;
  const Eigen::Vector3d upwards =
      std::abs(normal.y()) < kFlat ? Eigen::Vector3d::UnitY() : Eigen::Vector3d(0, 0, -1);
  out.up = (upwards - normal * normal.dot(upwards)).normalized();
  out.right = out.up.cross(normal);
  return out;
}

}  // namespace pentimento::sketch

#include "core/brush/tip_pose.h"

#include <algorithm>
#include <cmath>

#include "core/base/approx.h"

namespace pentimento {

namespace {
constexpr float kSmallestCells = 1.5f;  // diameter of the smallest tip a grid can show
constexpr float kLeanStretch = 0.5f;
constexpr float kLeanShift = 0.25f;  // of the diameter
constexpr float kLowestTilt = 1.4f;  // rad; a handle lies on the canvas no flatter than this

/// Direction and sine of the handle's lean. Tilts are the handle's angles in the planes of x and y.
Vec2f lean_of(const Stamp& stamp) {
  const auto tangent = [](float angle) {
    const float a = std::clamp(angle, -kLowestTilt, kLowestTilt);
    return approx::sin(a) / approx::cos(a);
  };
  if (stamp.tilt_x_rad == 0 && stamp.tilt_y_rad == 0) return {};
  const float x = tangent(stamp.tilt_x_rad), y = tangent(stamp.tilt_y_rad);
  const float norm = std::sqrt(1 + x * x + y * y);
  return {x / norm, y / norm};
}

/// Unit vector along the tip's u axis.
Vec2f axis_of(const Stamp& stamp, const BrushDefinition& brush) {
  Vec2f axis{1, 0};
  if (brush.follows_direction && (stamp.heading.x != 0 || stamp.heading.y != 0))
    axis = stamp.heading;
  if (brush.spreads_all_round() && (stamp.dab.x != 0 || stamp.dab.y != 0)) axis = stamp.dab;
  if (stamp.twist_rad == 0) return axis;
  const float c = approx::cos(stamp.twist_rad), s = approx::sin(stamp.twist_rad);
  return {axis.x * c - axis.y * s, axis.x * s + axis.y * c};  // y down: clockwise as seen
}

int cell_at(double place_m, double cell_m, int count) {
  return static_cast<int>(std::clamp(std::floor(place_m / cell_m), -1.0, count + 1.0));
}
}  // namespace

TipPose pose_of(const Stamp& stamp, const BrushDefinition& brush, float smallest_m) {
  const float pressure = pressure_of(stamp);
  TipPose pose;
  pose.diameter_m = std::max(smallest_m, stamp.diameter_m * brush.size_at(pressure));
  const Vec2f axis = axis_of(stamp, brush);
  const Vec2f lean = lean_of(stamp);
  const float lean_size = std::sqrt(lean.x * lean.x + lean.y * lean.y);
  const Vec2f along = lean_size > 0 ? Vec2f{lean.x / lean_size, lean.y / lean_size} : Vec2f{1, 0};
  const float stretch = 1 + kLeanStretch * lean_size;

  // S = stretch along the lean, 1 / stretch across; rows of the map are (axis, normal) S^-1 / D.
  const auto stretched = [&](const Vec2f& p, float by) {
    const float a = p.x * along.x + p.y * along.y;
    return Vec2f{p.x / by + along.x * a * (by - 1 / by), p.y / by + along.y * a * (by - 1 / by)};
  };
  const Vec2f normal{-axis.y, axis.x};
  const float D = pose.diameter_m;
  const Vec2f u = stretched(axis, 1 / stretch), v = stretched(normal, 1 / stretch);
  pose.u_x = u.x / D, pose.u_y = u.y / D, pose.v_x = v.x / D, pose.v_y = v.y / D;
  const Vec2f x = stretched(axis, stretch), y = stretched(normal, stretch);
  pose.x_u = x.x * D, pose.y_u = x.y * D, pose.x_v = y.x * D, pose.y_v = y.y * D;
  pose.x_m = stamp.x_m + static_cast<double>(kLeanShift * D * lean.x);
  pose.y_m = stamp.y_m + static_cast<double>(kLeanShift * D * lean.y);
  return pose;
}

TipPose pose_on(const CanvasGeometry& grid, const Stamp& stamp, const BrushDefinition& brush) {
  return pose_of(stamp, brush, kSmallestCells * cell_size_m(grid));
}

float cell_size_m(const CanvasGeometry& grid) {
  return std::sqrt(grid.dx_m() * grid.dy_m());
}

float cell_width(const TipPose& pose, const CanvasGeometry& grid) {
  const float along = pose.v_x * grid.dx_m(), down = pose.v_y * grid.dy_m();
  return std::sqrt(along * along + down * down);
}

FootprintBox box_of(const TipPose& pose, const TipExtent& extent, const CanvasGeometry& geometry) {
  const double cell_x = geometry.width_m / geometry.width;
  const double cell_y = geometry.height_m / geometry.height;
  // Half the tip's rectangle, and the cell or so by which the bilinear tip fades out.
  const double reach_x =
      0.5 * static_cast<double>(extent.u * std::abs(pose.x_u) + extent.v * std::abs(pose.x_v)) +
      1.3 * std::max(cell_x, cell_y);
  const double reach_y =
      0.5 * static_cast<double>(extent.u * std::abs(pose.y_u) + extent.v * std::abs(pose.y_v)) +
      1.3 * std::max(cell_x, cell_y);
  const int x0 = cell_at(pose.x_m - reach_x, cell_x, geometry.width);
  const int x1 = cell_at(pose.x_m + reach_x, cell_x, geometry.width) + 1;
  const int y0 = cell_at(pose.y_m - reach_y, cell_y, geometry.height);
  const int y1 = cell_at(pose.y_m + reach_y, cell_y, geometry.height) + 1;
  FootprintBox box;
  box.inside = x0 >= 0 && y0 >= 0 && x1 <= geometry.width && y1 <= geometry.height;
  box.x = std::max(x0, 0);
  box.y = std::max(y0, 0);
  box.width = std::min(x1, geometry.width) - box.x;
  box.height = std::min(y1, geometry.height) - box.y;
  return box;
}

TipRow tip_row(const TipPose& pose, const FootprintBox& box, const CanvasGeometry& geometry,
               int y) {
  const double cell_x = geometry.width_m / geometry.width;
  const double cell_y = geometry.height_m / geometry.height;
  const float dx = static_cast<float>((box.x + 0.5) * cell_x - pose.x_m);
  const float dy = static_cast<float>((y + 0.5) * cell_y - pose.y_m);
  const float step = static_cast<float>(cell_x);
  return {pose.u_x * dx + pose.u_y * dy, pose.v_x * dx + pose.v_y * dy, pose.u_x * step,
          pose.v_x * step};
}

}  // namespace pentimento

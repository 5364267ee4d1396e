#include "core/brush/edge_cells.h"

#include <algorithm>

namespace pentimento {

namespace {
constexpr float kLeastPassed = 0.05f;  // what is passed less is hardly touched

/// Squared cosine between the stamp's way and the tip's length.
float lengthwise(const StampPlan& plan) {
  const Vec2f way = plan.stamp.direction;
  const float u = plan.pose.u_x * way.x + plan.pose.u_y * way.y;
  const float v = plan.pose.v_x * way.x + plan.pose.v_y * way.y;
  const float length = u * u + v * v;
  return length > 0 ? u * u / length : 1.0f;
}
}  // namespace

BristleTable passed_shares(const StampPlan& plan, const CanvasGeometry& grid) {
  BristleTable share = plan.tip->reach_table().averaged(cell_width(plan.pose, grid));
  const float weight = lengthwise(plan);
  for (int i = 0; i <= BristleTable::kSteps; ++i)
    share[i] = std::max(kLeastPassed, 1 - weight * (1 - share[i]));
  return share;
}

float passed_height_m(const CanvasState& canvas, int x, int y, float share) {
  const auto surface = [&](int i, int j) { return canvas.base_m(i, j) + canvas.depth_m(i, j); };
  const float height = surface(x, y);
  if (!(share < 1)) return height;
  const int right = std::min(x + 1, canvas.geometry.width - 1), left = std::max(x - 1, 0);
  const int below = std::min(y + 1, canvas.geometry.height - 1), above = std::max(y - 1, 0);
  const float lowest =
      std::min({height, surface(left, y), surface(right, y), surface(x, above), surface(x, below)});
  return lowest + (height - lowest) / share;
}

}  // namespace pentimento

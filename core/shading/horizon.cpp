#include "core/shading/horizon.h"

#include <algorithm>
#include <cmath>

#include "core/shading/horizon_row.h"
#include "core/shading/lamp_uniforms.h"

namespace pentimento {
namespace {

constexpr double kPi = 3.14159265358979323846;

int reach_cells(const CanvasGeometry& grid) {
  const double smaller = std::min(grid.width_m / grid.width, grid.height_m / grid.height);
  const double cells = std::ceil(static_cast<double>(kHorizonRadius_m) / smaller);
  return static_cast<int>(std::clamp(cells, 2.0, static_cast<double>(kMostHorizonRadius_cells)));
}

/// 1, ... up to `last`, each about `ratio` times the one before.
std::vector<int> growing(double ratio, int last) {
  std::vector<int> out;
  for (double at = 1; at < last; at *= ratio) {
    const int whole = static_cast<int>(std::lround(at));
    if (out.empty() || out.back() != whole) out.push_back(whole);
  }
  if (out.empty() || out.back() < last) out.push_back(last);
  return out;
}

}  // namespace

int horizon_border(const CanvasGeometry& grid) {
  return reach_cells(grid) + 1;
}

HorizonLines horizon_lines(const CanvasGeometry& grid) {
  const double dx = grid.width_m / grid.width, dy = grid.height_m / grid.height;
  const double cell = std::min(dx, dy);
  HorizonLines lines;
  for (int d = 0; d < kSkyDirections; ++d) {
    const double angle = 2 * kPi * (d + 0.5) / kSkyDirections;
    for (const int n : growing(2, reach_cells(grid))) {
      double right = std::round(n * cell * std::cos(angle) / dx);
      double down = std::round(n * cell * std::sin(angle) / dy);
      // Long cells: the nearest in this direction, along their shorter side at least.
      if (right == 0 && down == 0) (dx < dy ? right : down) = 1;
      const double distance = std::sqrt(right * dx * right * dx + down * dy * down * dy);
      lines.sky.push_back(
          {static_cast<float>(right), static_cast<float>(down), static_cast<float>(1 / distance)});
    }
  }
  for (const int n : growing(1.4, reach_cells(grid))) lines.shadow.push_back(static_cast<float>(n));
  return lines;
}

HorizonSearch::HorizonSearch(const CanvasGeometry& grid, const Lighting& lighting,
                             const Threads& threads)
    : grid_(grid),
      lamps_(shining(lighting)),
      relief_scale_(lighting.relief_scale),
      threads_(threads),
      lines_(horizon_lines(grid)),
      border_(horizon_border(grid)),
      planes_(static_cast<std::size_t>(horizon_planes(static_cast<int>(lamps_.size())))) {}

const std::vector<std::vector<float>>& HorizonSearch::search(const std::vector<float>& relief,
                                                             const CellWindow& window) {
  const auto width = static_cast<std::size_t>(window.width);
  const std::ptrdiff_t stride = window.width + 2 * border_;
  height_.resize(relief.size() / 2);
  const auto rows = static_cast<std::size_t>(stride);
  threads_.for_rows(window.height + 2 * border_, [&](int y) {
    const std::size_t first = rows * static_cast<std::size_t>(y);
    for (std::size_t i = first; i < first + rows; ++i) height_[i] = relief[2 * i] * relief_scale_;
  });
  for (std::vector<float>& plane : planes_)
    plane.assign(4 * width * static_cast<std::size_t>(window.height), 1.0f);
  const float dx = grid_.dx_m(), dy = grid_.dy_m();
  threads_.for_rows(window.height, [&](int y) {
    std::vector<float> seen(width);
    const HeightRows around = {height_.data() + (y + border_) * stride + border_, stride, dx, dy};
    const auto put = [&](std::size_t value) {
      float* out = planes_[value / 4].data() + 4 * width * static_cast<std::size_t>(y) + value % 4;
      for (std::size_t x = 0; x < width; ++x) out[4 * x] = seen[x];
    };
    sky_seen_row(around, lines_, seen);
    put(0);
    for (std::size_t i = 0; i < lamps_.size(); ++i) {
      if (lamps_[i].position_m) {
        const NearLamp lamp = {
            *lamps_[i].position_m,
            {static_cast<float>(grid_.width_m / 2), static_cast<float>(grid_.height_m / 2)},
            window.x,
            window.y + y,
            relief_scale_ > 0 ? 1 / relief_scale_ : 0};
        near_lamp_seen_row(around, lines_, lamp, seen);
      } else {
        lamp_seen_row(around, lines_, lamps_[i].direction, seen);
      }
      put(i + 1);
    }
  });
  return planes_;
}

}  // namespace pentimento

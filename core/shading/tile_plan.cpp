#include "core/shading/tile_plan.h"

#include <algorithm>
#include <cstdint>

namespace pentimento {
namespace {

constexpr int kMostTile = 8192;
constexpr int kMostWindow = 4096;
constexpr int kMostSamples = 16384;  // a row of the sample table is a texture
constexpr std::int64_t kMiB = std::int64_t{1} << 20;
constexpr std::int64_t kRgbaBytes = 16;

/// Largest count of pixels, at most `wanted`, whose window and samples fit; at least 1.
int fitting(const SampleAxis& axis, int wanted, int border) {
  int count = std::min({wanted, kMostTile, kMostSamples / axis.per_pixel});
  while (count > 1 && axis.most_cells(count) + 2 * border > kMostWindow) count = (count + 1) / 2;
  return std::max(count, 1);
}

std::vector<PixelRun> runs(PixelRun crop, int side) {
  std::vector<PixelRun> out;
  for (int at = 0; at < crop.count; at += side) {
    out.push_back({crop.first + at, std::min(side, crop.count - at)});
  }
  return out;
}

bool within_budgets(const TileDemand& d, std::int64_t width, std::int64_t height) {
  const std::int64_t window = static_cast<std::int64_t>(d.x.most_cells(static_cast<int>(width))) *
                              d.y.most_cells(static_cast<int>(height));
  return window * d.input_texels * kRgbaBytes <= 512 * kMiB &&
         width * height * d.targets * kRgbaBytes <= 1024 * kMiB &&
         std::int64_t{d.crop_x.count} * height * d.planes * 4 <= 256 * kMiB;
}

}  // namespace

TilePlan plan_tiles(const TileDemand& demand) {
  TilePlan plan;
  plan.width = fitting(demand.x, std::min(demand.tile, demand.crop_x.count), demand.border);
  plan.height = fitting(demand.y, std::min(demand.tile, demand.crop_y.count), demand.border);
  while (plan.height > 1 && !within_budgets(demand, plan.width, plan.height)) {
    plan.height = (plan.height + 1) / 2;
  }
  plan.columns = runs(demand.crop_x, plan.width);
  plan.rows = runs(demand.crop_y, plan.height);
  return plan;
}

}  // namespace pentimento

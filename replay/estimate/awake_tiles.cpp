#include "replay/estimate/awake_tiles.h"

#include <algorithm>
#include <bit>

#include "core/base/give_back.h"

namespace pentimento {

namespace {
// After a touch paint moves this long; then it stands (mean over the samples). Thin paint, the more
// of it the longer.
constexpr std::int64_t kSettlingSteps = 9, kRunningSteps = 45;
constexpr float kThinPigment = 0.3f;
constexpr double kWakingTilt_m_s2 = 0.3;  // more than this along the canvas, and all paint moves
constexpr int kSide = 32;                 // cells

int tiles_along(int cells) {
  return (cells + kSide - 1) / kSide;
}
}  // namespace

bool deposits_thin_paint(const BrushSettings& brush) {
  return brush.pigment_frac < kThinPigment;
}

std::int64_t settling_steps(const BrushSettings& brush) {
  if (!deposits_thin_paint(brush)) return kSettlingSteps;
  return kSettlingSteps + static_cast<std::int64_t>(kRunningSteps * brush.medium_frac);
}

AwakeTiles::AwakeTiles(const CanvasGeometry& grid)
    : width_(grid.width),
      height_(grid.height),
      columns_(tiles_along(grid.width)),
      tiles_(static_cast<std::size_t>(columns_ * tiles_along(grid.height))),
      ever_(tiles_.size(), 0) {}

void AwakeTiles::touch(int x, int y, const PaintedCells& touch) {
  if (touch.step >= next_look_) {
    look();
    next_look_ = (touch.step / kStepsBetweenGivingBack + 1) * kStepsBetweenGivingBack;
  }
  last_touch_ = touch.step;
  const auto at = static_cast<std::size_t>(y / kSide * columns_ + x / kSide);
  Tile& tile = tiles_[at];
  ever_[at] = 1;
  if (tile.touched < 0) ++wet_tiles_;
  if (tile.touched >= 0 && touch.step > tile.touched && tilted_since_ < 0)
    add(tile, std::min(tile.settling_steps, touch.step - tile.touched));
  tile = {touch.step, touch.settling_steps, tile.mask | touch.mask};
}

void AwakeTiles::touch(int x, int y, int width, int height, const PaintedCells& touch) {
  for (int j = y / kSide; j <= (y + height - 1) / kSide; ++j)
    for (int i = x / kSide; i <= (x + width - 1) / kSide; ++i)
      this->touch(i * kSide, j * kSide, touch);
}

void AwakeTiles::add(const Tile& tile, std::int64_t steps) {
  const double cells = static_cast<double>(steps) * kSide * kSide;
  awake_.cell_steps += cells;
  awake_.channel_steps += cells * std::popcount(tile.mask);
}

void AwakeTiles::tilt(double lateral_m_s2, std::int64_t step) {
  if (tilted_since_ >= 0)
    tilted_cell_steps_ += static_cast<double>((step - tilted_since_) * wet_tiles_) * kSide * kSide;
  tilted_since_ = lateral_m_s2 > kWakingTilt_m_s2 ? step : -1;
}

void AwakeTiles::look() {
  std::vector<std::uint8_t> used(tiles_.size(), 0);
  std::transform(tiles_.begin(), tiles_.end(), used.begin(), [&](const Tile& tile) {
    // On a flat canvas a pool of thin paint may move for minutes.
    const bool runs = tile.settling_steps > kSettlingSteps;
    return tile.touched >= 0 && (runs || tile.touched + tile.settling_steps >=
                                             last_touch_ - 2 * kStepsBetweenGivingBack);
  });
  const auto count = std::count(used.begin(), used.end(), std::uint8_t{1});
  if (count <= most_used_) return;
  most_used_ = count;
  used_ = std::move(used);
}

void AwakeTiles::clear() {
  look();
  std::fill(tiles_.begin(), tiles_.end(), Tile());
  wet_tiles_ = 0;
}

double AwakeTiles::reached_share(int width, int height) const {
  return share_near(ever_, width, height);
}

double AwakeTiles::most_used_share(int width, int height) const {
  return used_.empty() ? 0 : share_near(used_, width, height);
}

double AwakeTiles::share_near(const std::vector<std::uint8_t>& tiles, int width, int height) const {
  const int across = (width_ + width - 1) / width, down = (height_ + height - 1) / height;
  std::vector<std::uint8_t> reached(static_cast<std::size_t>(across * down), 0);
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    if (tiles[tile] == 0) continue;
    // The tile and as much on each side of it.
    const int x = static_cast<int>(tile) % columns_ * kSide - kSide;
    const int y = static_cast<int>(tile) / columns_ * kSide - kSide;
    const int right = std::min((x + 3 * kSide - 1) / width, across - 1);
    const int bottom = std::min((y + 3 * kSide - 1) / height, down - 1);
    for (int j = std::max(y, 0) / height; j <= bottom; ++j)
      for (int i = std::max(x, 0) / width; i <= right; ++i)
        reached[static_cast<std::size_t>(j * across + i)] = 1;
  }
  const auto count = std::count(reached.begin(), reached.end(), std::uint8_t{1});
  return static_cast<double>(count) / static_cast<double>(reached.size());
}

void AwakeTiles::finish(std::int64_t step) {
  tilt(0, step);
  look();
  for (const Tile& tile : tiles_)
    if (tile.touched >= 0)
      add(tile, std::clamp<std::int64_t>(step - tile.touched, 0, tile.settling_steps));
}

}  // namespace pentimento

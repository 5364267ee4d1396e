#include "core/fluid/conservative/tiles/live_tiles.h"

#include <algorithm>

namespace pentimento::conservative {

void LiveTiles::find(const SleepTiles& tiles, const Threads& threads,
                     const std::function<bool(int)>& stirs) {
  const std::vector<int>& awake = tiles.awake_tiles();
  live_.resize(static_cast<std::size_t>(tiles.count()), 0);
  std::fill(live_.begin(), live_.end(), std::uint8_t{0});
  threads.for_ranges(0, static_cast<int>(awake.size()), 16, [&](int begin, int end) {
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k)
      live_[static_cast<std::size_t>(awake[k])] = stirs(awake[k]) ? 1 : 0;
  });
  spread(tiles);
}

std::vector<Run> LiveTiles::live_of(const std::vector<Run>& runs, const SleepTiles& tiles) const {
  std::vector<Run> out;
  for (const Run& r : runs)
    if (live(r.y / tiles.tile_height() * tiles.columns() + r.x0 / tiles.tile_width()))
      out.push_back(r);
  return out;
}

// Makes every awake tile live that a live tile reaches over sides of awake tiles.
void LiveTiles::spread(const SleepTiles& tiles) {
  edge_.clear();
  for (const int tile : tiles.awake_tiles())
    if (live_[static_cast<std::size_t>(tile)]) edge_.push_back(tile);
  const auto reach = [&](int column, int row) {
    if (column < 0 || row < 0 || column >= tiles.columns() || row >= tiles.rows()) return;
    const int tile = row * tiles.columns() + column;
    if (!tiles.awake(column, row) || live_[static_cast<std::size_t>(tile)]) return;
    live_[static_cast<std::size_t>(tile)] = 1;
    edge_.push_back(tile);
  };
  while (!edge_.empty()) {
    const int column = edge_.back() % tiles.columns();
    const int row = edge_.back() / tiles.columns();
    edge_.pop_back();
    reach(column - 1, row);
    reach(column + 1, row);
    reach(column, row - 1);
    reach(column, row + 1);
  }
}

}  // namespace pentimento::conservative

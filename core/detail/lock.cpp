#include "core/detail/lock.h"

#include <algorithm>

#include "core/detail/block_rows.h"

namespace pentimento {

namespace {
constexpr int kSmoothings = 3;
constexpr float kClose = 1e-6f;     // a float's mean of a block is not known better
constexpr float kMostSmoothed = 4;  // ratios beyond would drag their neighbours along
constexpr float kMostScaled = 16;   // blocks that owe more are filled

void for_tiles(DetailCanvas& canvas, const WetPlane& q, const std::vector<int>& tiles,
               const Threads& threads, const auto& body) {
  threads.for_ranges(0, static_cast<int>(tiles.size()), 1, [&](int begin, int end) {
    for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t) {
      DetailTile* tile = canvas.find(tiles[t]);
      if (tile != nullptr && q.of(*tile)) body(t, *tile);
    }
  });
}

void count_ratio(float ratio, LockStatistics& s) {
  const float off = ratio < 1 ? 1 - ratio : ratio - 1;
  std::size_t bin = 0;
  while (bin < LockStatistics::kBound.size() && off > LockStatistics::kBound[bin]) ++bin;
  ++s.blocks[bin];
}

bool near_one(const Field<float>& ratio, const GuideBox& box) {
  const int x0 = std::max(0, box.x0 - 1), x1 = std::min(ratio.width(), box.x1 + 1);
  const int y0 = std::max(0, box.y0 - 1), y1 = std::min(ratio.height(), box.y1 + 1);
  for (int y = y0; y < y1; ++y)
    for (int x = x0; x < x1; ++x)
      if (ratio(x, y) != 1) return false;
  return true;
}
}  // namespace

void Lock::lock(DetailCanvas& canvas, const CanvasState& guide, const std::vector<int>& tiles,
                const Threads& threads) {
  counted_.assign(tiles.size(), {});
  for (int p = -1; p < canvas.layers() * canvas.channels(); ++p)
    lock_plane(canvas, guide, WetPlane{p}, tiles, threads);
  for (const LockStatistics& s : counted_) {
    for (std::size_t i = 0; i < s.blocks.size(); ++i) statistics_.blocks[i] += s.blocks[i];
    statistics_.owed += s.owed;
  }
}

void Lock::lock_plane(DetailCanvas& canvas, const CanvasState& guide, const WetPlane& q,
                      const std::vector<int>& tiles, const Threads& threads) {
  const int k = canvas.layout().factor(), side = canvas.layout().side();
  for (int i = 0; i < kSmoothings; ++i) {
    if (!find_ratios(canvas, guide, q, tiles, threads, i == 0)) break;
    for_tiles(canvas, q, tiles, threads, [&](std::size_t, DetailTile& tile) {
      if (!near_one(ratio_, tile.box))
        scale_by_field(ratio_.view(), k, tile.box, q.of(tile).data(), side);
    });
  }
  for (const int t : tiles) {
    const GuideBox box = canvas.layout().box(t);
    for (int y = box.y0; y < box.y1; ++y) std::fill_n(ratio_.row(y) + box.x0, box.width(), 1.0f);
  }
  make_exact(canvas, guide, q, tiles, threads);
}

/// The ratios of all blocks of the tiles. False if all are 1.
bool Lock::find_ratios(DetailCanvas& canvas, const CanvasState& guide, const WetPlane& q,
                       const std::vector<int>& tiles, const Threads& threads, bool count) {
  const int k = canvas.layout().factor(), side = canvas.layout().side();
  off_.assign(tiles.size(), 0);
  for_tiles(canvas, q, tiles, threads, [&](std::size_t t, DetailTile& tile) {
    std::vector<float> mean(static_cast<std::size_t>(tile.box.width() * tile.box.height()));
    block_means(q.of(tile).data(), side, k, tile.box, mean);
    std::size_t block = 0;
    for (int y = tile.box.y0; y < tile.box.y1; ++y) {
      const float* wanted = q.of(guide).row(y);
      float* ratio = ratio_.row(y);
      for (int x = tile.box.x0; x < tile.box.x1; ++x, ++block) {
        ratio[x] = 1;
        if (!(wanted[x] > 0) || !(mean[block] > 0)) continue;
        const float r = wanted[x] / mean[block];
        if (count) count_ratio(r, counted_[t]);
        if (r > 1 - kClose && r < 1 + kClose) continue;
        ratio[x] = std::clamp(r, 1 / kMostSmoothed, kMostSmoothed);
        off_[t] = 1;
      }
    }
  });
  return std::any_of(off_.begin(), off_.end(), [](std::uint8_t off) { return off != 0; });
}

void Lock::make_exact(DetailCanvas& canvas, const CanvasState& guide, const WetPlane& q,
                      const std::vector<int>& tiles, const Threads& threads) {
  const int k = canvas.layout().factor(), side = canvas.layout().side();
  owed_.assign(tiles.size(), {});
  for_tiles(canvas, q, tiles, threads, [&](std::size_t t, DetailTile& tile) {
    std::vector<float> scale(static_cast<std::size_t>(tile.box.width() * tile.box.height()));
    block_means(q.of(tile).data(), side, k, tile.box, scale);
    std::size_t block = 0;
    for (int y = tile.box.y0; y < tile.box.y1; ++y) {
      const float* wanted = q.of(guide).row(y);
      for (int x = tile.box.x0; x < tile.box.x1; ++x, ++block) {
        const float mean = scale[block];
        scale[block] = 1;
        if (!(wanted[x] > 0)) {
          scale[block] = 0;
        } else if (!(wanted[x] <= kMostScaled * mean)) {
          owed_[t].push_back({x, y, wanted[x], {}});
        } else {
          scale[block] = wanted[x] / mean;
        }
      }
    }
    counted_[t].owed += static_cast<std::int64_t>(owed_[t].size());
    scale_blocks(scale, k, tile.box, q.of(tile).data(), side);
  });
  // All are decided from the canvas as it is before any is written: neighbours may both owe.
  for_tiles(canvas, q, tiles, threads, [&](std::size_t t, DetailTile&) {
    for (OwedBlock& block : owed_[t]) fill_owed(canvas, q, block);
  });
  for_tiles(canvas, q, tiles, threads, [&](std::size_t t, DetailTile&) {
    for (const OwedBlock& block : owed_[t]) store_owed(canvas, q, block);
  });
}

}  // namespace pentimento

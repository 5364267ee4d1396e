#include "core/detail/lock.h"

#include <algorithm>

#include "core/detail/block_rows.h"
#include "core/detail/open_cells.h"

namespace pentimento {

struct Lock::Job {
  DetailCanvas& canvas;
  const CanvasState& guide;
  const std::vector<int>& tiles;
  const Threads& threads;

  /// Calls body(index, tile) for each tile, in parallel.
  template <typename Body>
  void for_tiles(const Body& body) const {
    threads.for_ranges(0, static_cast<int>(tiles.size()), 1, [&](int begin, int end) {
      for (auto t = static_cast<std::size_t>(begin); t < static_cast<std::size_t>(end); ++t)
        if (DetailTile* tile = canvas.find(tiles[t])) body(t, *tile);
    });
  }
};

namespace {
constexpr int kSmoothings = 3;
constexpr float kClose = 1e-6f;     // a float's mean of a block is not known better
constexpr float kMostSmoothed = 4;  // ratios beyond would drag their neighbours along
constexpr float kMostScaled = 16;   // blocks that owe more are filled

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

/// What the guide wants in the blocks of a tile, and what they hold, for each plane of a group.
class BlockTable {
 public:
  BlockTable(const DetailLayout& layout, const CanvasState& guide, DetailTile& tile,
             const std::vector<WetPlane>& group, const std::vector<std::uint8_t>& split)
      : blocks_(static_cast<std::size_t>(tile.box.width() * tile.box.height())) {
    for (const WetPlane& q : group) {
      std::vector<float> wanted, held(blocks_, 0.0f);
      for (int y = tile.box.y0; y < tile.box.y1; ++y)
        wanted.insert(wanted.end(), q.of(guide).row(y) + tile.box.x0,
                      q.of(guide).row(y) + tile.box.x1);
      if (q.of(tile))
        block_means(q.of(tile).data(), layout.side(), layout.factor(), tile.box, held);
      wanted_.push_back(std::move(wanted));
      held_.push_back(std::move(held));
    }
    if (group.size() > 1) add_up_split(split);
  }
  float wanted(std::size_t plane, std::size_t block) const { return wanted_[plane][block]; }
  float held(std::size_t plane, std::size_t block) const { return held_[plane][block]; }

 private:
  void add_up_split(const std::vector<std::uint8_t>& split) {
    for (std::size_t b = 0; b < blocks_; ++b) {
      if (split[b] == 0) continue;
      for (std::vector<std::vector<float>>* table : {&wanted_, &held_}) {
        float sum = 0;
        for (const std::vector<float>& plane : *table) sum += plane[b];
        for (std::vector<float>& plane : *table) plane[b] = sum;
      }
    }
  }

  std::size_t blocks_;
  std::vector<std::vector<float>> wanted_, held_;  // per plane, per block
};

std::vector<std::uint8_t> find_split(const DetailLayout& layout, const DetailTile& tile) {
  std::vector<std::uint8_t> split;
  for (int y = tile.box.y0; y < tile.box.y1; ++y)
    for (int x = tile.box.x0; x < tile.box.x1; ++x)
      split.push_back(layers_correspond(tile, layout, x, y) ? 0 : 1);
  return split;
}
}  // namespace

Lock::Lock(const DetailLayout& layout, int layers) {
  for (int i = 0; i < layers; ++i)
    ratio_.emplace_back(layout.guide().width, layout.guide().height, 1.0f);
}

void Lock::lock(DetailCanvas& canvas, const CanvasState& guide, const std::vector<int>& tiles,
                const Threads& threads) {
  const Job job{canvas, guide, tiles, threads};
  counted_.assign(tiles.size(), {});
  split_.assign(tiles.size(), {});
  job.for_tiles(
      [&](std::size_t t, DetailTile& tile) { split_[t] = find_split(canvas.layout(), tile); });
  lock_group(job, {WetPlane{}});
  for (int c = 0; c < canvas.channels(); ++c) {
    Group group;
    for (int layer = 0; layer < canvas.layers(); ++layer)
      group.push_back(WetPlane{layer * canvas.channels() + c});
    lock_group(job, group);
  }
  for (const LockStatistics& s : counted_) {
    for (std::size_t i = 0; i < s.blocks.size(); ++i) statistics_.blocks[i] += s.blocks[i];
    statistics_.owed += s.owed;
  }
}

void Lock::lock_group(const Job& job, const Group& group) {
  const int k = job.canvas.layout().factor(), side = job.canvas.layout().side();
  for (int i = 0; i < kSmoothings; ++i) {
    if (!find_ratios(job, group, i == 0)) break;
    job.for_tiles([&](std::size_t, DetailTile& tile) {
      for (std::size_t p = 0; p < group.size(); ++p)
        if (group[p].of(tile) && !near_one(ratio_[p], tile.box))
          scale_by_field(ratio_[p].view(), k, tile.box, group[p].of(tile).data(), side);
    });
  }
  for (std::size_t p = 0; p < group.size(); ++p) {
    for (const int t : job.tiles) {
      const GuideBox box = job.canvas.layout().box(t);
      for (int y = box.y0; y < box.y1; ++y)
        std::fill_n(ratio_[p].row(y) + box.x0, box.width(), 1.0f);
    }
  }
  make_exact(job, group);
}

/// The ratios of all blocks of the tiles. False if all are 1.
bool Lock::find_ratios(const Job& job, const Group& group, bool count) {
  off_.assign(job.tiles.size(), 0);
  job.for_tiles([&](std::size_t t, DetailTile& tile) {
    const BlockTable table(job.canvas.layout(), job.guide, tile, group, split_[t]);
    for (std::size_t p = 0; p < group.size(); ++p) {
      std::size_t block = 0;
      for (int y = tile.box.y0; y < tile.box.y1; ++y) {
        float* ratio = ratio_[p].row(y);
        for (int x = tile.box.x0; x < tile.box.x1; ++x, ++block) {
          ratio[x] = 1;
          const float wanted = table.wanted(p, block), held = table.held(p, block);
          if (!(wanted > 0) || !(held > 0)) continue;
          const float r = wanted / held;
          if (count) count_ratio(r, counted_[t]);
          if (r > 1 - kClose && r < 1 + kClose) continue;
          ratio[x] = std::clamp(r, 1 / kMostSmoothed, kMostSmoothed);
          off_[t] = 1;
        }
      }
    }
  });
  return std::any_of(off_.begin(), off_.end(), [](std::uint8_t off) { return off != 0; });
}

void Lock::make_exact(const Job& job, const Group& group) {
  const int k = job.canvas.layout().factor(), side = job.canvas.layout().side();
  owed_.assign(job.tiles.size(), {});
  job.for_tiles([&](std::size_t t, DetailTile& tile) {
    const BlockTable table(job.canvas.layout(), job.guide, tile, group, split_[t]);
    std::vector<float> scale(static_cast<std::size_t>(tile.box.width() * tile.box.height()));
    for (std::size_t p = 0; p < group.size(); ++p) {
      if (!group[p].of(tile)) continue;
      std::size_t block = 0;
      for (int y = tile.box.y0; y < tile.box.y1; ++y) {
        for (int x = tile.box.x0; x < tile.box.x1; ++x, ++block) {
          const float wanted = table.wanted(p, block), held = table.held(p, block);
          scale[block] = 1;
          if (!(wanted > 0)) {
            scale[block] = 0;
          } else if (wanted <= kMostScaled * held) {
            scale[block] = wanted / held;
          } else {
            // What the guide has in this very layer, split or not.
            owed_[t].push_back({x, y, static_cast<int>(p), group[p].of(job.guide)(x, y), {}});
          }
        }
      }
      scale_blocks(scale, k, tile.box, group[p].of(tile).data(), side);
    }
    counted_[t].owed += static_cast<std::int64_t>(owed_[t].size());
  });
  // All are decided from the canvas as it is before any is written: neighbours may both owe.
  job.for_tiles([&](std::size_t t, DetailTile&) {
    for (OwedBlock& block : owed_[t])
      fill_owed(job.canvas, group[static_cast<std::size_t>(block.plane)], block);
  });
  job.for_tiles([&](std::size_t t, DetailTile&) {
    for (const OwedBlock& block : owed_[t])
      store_owed(job.canvas, group[static_cast<std::size_t>(block.plane)], block);
  });
}

}  // namespace pentimento

#include "core/detail/lock/lock.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/detail/store/block_rows.h"
#include "core/detail/store/open_cells.h"

namespace pentimento {

struct Lock::Job {
  DetailCanvas& canvas;
  const CanvasState& guide;
  const Threads& threads;
  int grain_size;  // strips worth a task of their own

  BlockRow row_of(const Strip& strip, const WetPlane& q) const {
    return block_row(q.of(*strip.tile).data(), canvas.layout(), strip.at);
  }
};

namespace {
constexpr int kSmoothings = 3;
constexpr float kClose = 1e-6f;     // the mean of a block in floats is not more exact than this
constexpr float kMostSmoothed = 2;  // larger ratios would pull their neighbours along
constexpr float kMostScaled = 16;   // blocks that must grow by more are filled instead
constexpr int kCellsPerTask = 16384;

void count_ratio(float ratio, LockStatistics& s) {
  const float off = ratio < 1 ? 1 - ratio : ratio - 1;
  std::size_t bin = 0;
  while (bin < LockStatistics::kBound.size() && off > LockStatistics::kBound[bin]) ++bin;
  ++s.blocks[bin];
}

/// The part of a strip that a ratio other than 1 reaches.
BlockStrip off_part(const RatioRows& rows, BlockStrip strip) {
  const auto off = [&](int x) {
    return rows.above[x] != 1 || rows.here[x] != 1 || rows.below[x] != 1;
  };
  const auto reached = [&](int x) {
    return off(x) || (x > 0 && off(x - 1)) || (x + 1 < rows.width && off(x + 1));
  };
  while (strip.x0 < strip.x1 && !reached(strip.x0)) ++strip.x0;
  while (strip.x0 < strip.x1 && !reached(strip.x1 - 1)) --strip.x1;
  return strip;
}
}  // namespace

Lock::Lock(const DetailLayout& layout, int layers) {
  for (std::vector<Field<float>>& ratio : ratio_)
    for (int i = 0; i < layers; ++i)
      ratio.emplace_back(layout.guide().width, layout.guide().height, 1.0f);
}

void Lock::lock(DetailCanvas& canvas, const CanvasState& guide,
                const std::vector<BlockStrip>& strips, const Threads& threads) {
  // Which strips to lock; how many of them make a task.
  list(canvas, strips);
  if (strips_.empty()) return;
  const auto fine = blocks_ * static_cast<std::size_t>(canvas.layout().factor()) *
                    static_cast<std::size_t>(canvas.layout().factor());
  const auto cells = static_cast<int>(fine / strips_.size());
  const Job job{canvas, guide, threads, std::max(1, kCellsPerTask / std::max(1, cells))};
  // The depth alone; then each pigment channel with all its layers, for a mismatched block is
  // locked as the sum of its layers.
  lock_group(job, {WetPlane{}});
  for (int c = 0; c < canvas.channels(); ++c) {
    Group group;
    for (int layer = 0; layer < canvas.layers(); ++layer)
      group.push_back(WetPlane{layer * canvas.channels() + c});
    lock_group(job, group);
  }
  // Each strip counted for itself: the sums do not depend on the threads.
  for (const LockStatistics& s : counted_) {
    for (std::size_t i = 0; i < s.blocks.size(); ++i) statistics_.blocks[i] += s.blocks[i];
    statistics_.owed += s.owed;
  }
}

/// Lists the strips that have a tile, and for each block whether its layers are those of the
/// guide's cell.
void Lock::list(DetailCanvas& canvas, const std::vector<BlockStrip>& strips) {
  strips_.clear();
  split_.clear();
  for (const BlockStrip& at : strips) {
    DetailTile* tile = canvas.find(at.tile);
    if (tile == nullptr) continue;
    strips_.push_back({at, tile, split_.size()});
    for (int x = at.x0; x < at.x1; ++x) {
      split_.push_back(layers_correspond(*tile, canvas.layout(), x, at.y) ? 0 : 1);
      strips_.back().is_split |= split_.back() != 0;
    }
  }
  blocks_ = split_.size();
  counted_.assign(strips_.size(), {});
  off_.assign(strips_.size(), 0);
  if (uncovered_.size() < strips_.size()) uncovered_.resize(strips_.size());
}

template <typename Body>
void Lock::for_strips(const Job& job, const Body& body) {
  job.threads.for_ranges(
      0, static_cast<int>(strips_.size()), job.grain_size, [&](int begin, int end) {
        for (auto s = static_cast<std::size_t>(begin); s < static_cast<std::size_t>(end); ++s)
          body(s);
      });
}

void Lock::lock_group(const Job& job, const Group& group) {
  // What each block holds, and by which ratio it is off.
  held_.assign(group.size() * blocks_, 0.0f);
  wants_.assign(group.size() * strips_.size(), 0);
  holds_.assign(group.size() * strips_.size(), 0);
  for_strips(job, [&](std::size_t s) {
    measure(job, group, s);
    find_ratios(job, group, s, 0);
  });
  const auto any_off = [&] {
    return std::any_of(off_.begin(), off_.end(), [](std::uint8_t off) { return off != 0; });
  };
  // Smooth passes: the ratios are spread as a smooth field, so that no block shows its border. Each
  // pass finds the ratios that are left.
  for (int pass = 1; pass <= kSmoothings && any_off(); ++pass) {
    for_strips(job, [&](std::size_t s) {
      for (std::size_t p = 0; p < group.size(); ++p)
        if (holds_[p * strips_.size() + s] != 0) smooth(job, group[p], p, strips_[s], pass);
      if (pass < kSmoothings) find_ratios(job, group, s, pass);
    });
  }
  for (std::size_t p = 0; p < group.size(); ++p)
    for (const Strip& strip : strips_)
      for (std::vector<Field<float>>& ratio : ratio_)
        std::fill_n(ratio[p].row(strip.at.y) + strip.at.x0, strip.at.blocks(), 1.0f);
  // The exact pass: what is still off is scaled block by block. Blocks with next to nothing to
  // scale are filled.
  for_strips(job, [&](std::size_t s) { make_exact(job, group, s); });
  fill_uncovered_blocks(job, group);
}

/// What the blocks of a strip hold, and whether there is anything to compare.
void Lock::measure(const Job& job, const Group& group, std::size_t s) {
  const Strip& strip = strips_[s];
  for (std::size_t p = 0; p < group.size(); ++p) {
    const float* wanted = group[p].of(job.guide).row(strip.at.y) + strip.at.x0;
    wants_[p * strips_.size() + s] = any_not_zero(wanted, strip.at.blocks()) ? 1 : 0;
    if (!group[p].of(*strip.tile)) continue;
    const std::span<float> held = held_of(p, strip);
    block_means(job.row_of(strip, group[p]), held);
    holds_[p * strips_.size() + s] = any_not_zero(held.data(), strip.at.blocks()) ? 1 : 0;
  }
}

/// A flag of a plane in a strip; where blocks are mismatched, of all planes of the group.
bool Lock::any(const std::vector<std::uint8_t>& flags, std::size_t plane, std::size_t s) const {
  const std::size_t strips = strips_.size();
  if (!strips_[s].is_split) return flags[plane * strips + s] != 0;
  for (std::size_t i = s; i < flags.size(); i += strips)
    if (flags[i] != 0) return true;
  return false;
}

/// Multiplies the fine cells of a strip by the ratios of the pass before, as a smooth field. Keeps
/// `held_` up to date.
void Lock::smooth(const Job& job, const WetPlane& q, std::size_t plane, const Strip& strip,
                  int pass) {
  const Field<float>& ratio = ratio_[at(pass + 1) % 2][plane];
  const BlockStrip part = off_part(ratio_rows(ratio, 0, strip.at.y), strip.at);
  if (part.blocks() <= 0) return;
  scale_by_field(ratio_rows(ratio, part.x0, part.y),
                 block_row(q.of(*strip.tile).data(), job.canvas.layout(), part),
                 held_of(plane, strip).subspan(at(part.x0 - strip.at.x0), at(part.blocks())));
}

/// What the guide wants in a block and what the block holds: of one plane, or in a mismatched block
/// of all layers of a pigment channel.
Lock::Target Lock::target_of(const Job& job, const Group& group, std::size_t plane,
                             const Strip& strip, int block) const {
  const std::size_t b = strip.first + at(block);
  const int x = strip.at.x0 + block, y = strip.at.y;
  if (split_[b] == 0 || group.size() == 1)
    return {group[plane].of(job.guide)(x, y), held_[plane * blocks_ + b]};
  Target sum;
  for (std::size_t p = 0; p < group.size(); ++p) {
    sum.wanted += group[p].of(job.guide)(x, y);
    sum.held += held_[p * blocks_ + b];
  }
  return sum;
}

void Lock::find_ratios(const Job& job, const Group& group, std::size_t s, int pass) {
  const Strip& strip = strips_[s];
  off_[s] = 0;
  for (std::size_t p = 0; p < group.size(); ++p) {
    if (!any(wants_, p, s) || !any(holds_, p, s)) continue;  // the ratios are 1, and stay so
    float* ratio = ratio_[at(pass) % 2][p].row(strip.at.y) + strip.at.x0;
    for (int i = 0; i < strip.at.blocks(); ++i) {
      ratio[i] = 1;
      const Target c = target_of(job, group, p, strip, i);
      if (!(c.wanted > 0) || !(c.held > 0)) continue;
      const float r = c.wanted / c.held;
      if (pass == 0) count_ratio(r, counted_[s]);
      if (r > 1 - kClose && r < 1 + kClose) continue;
      if (r < 1 / kMostSmoothed || r > kMostSmoothed) continue;
      ratio[i] = r;
      off_[s] = 1;
    }
  }
}

void Lock::make_exact(const Job& job, const Group& group, std::size_t s) {
  const Strip& strip = strips_[s];
  uncovered_[s].clear();
  std::array<float, kMostTileSide> scale;
  for (std::size_t p = 0; p < group.size(); ++p) {
    if (!group[p].of(*strip.tile)) continue;
    if (!any(wants_, p, s) && !any(holds_, p, s)) continue;
    bool all_one = true;
    for (int i = 0; i < strip.at.blocks(); ++i) {
      const Target c = target_of(job, group, p, strip, i);
      float& by = scale[at(i)];
      by = 1;
      if (!(c.wanted > 0)) {
        by = c.held > 0 ? 0.0f : 1.0f;
      } else if (c.wanted <= kMostScaled * c.held) {
        by = c.wanted / c.held;
      } else {
        // Fill up to what the guide has in this very layer, even if the block's layers are
        // mismatched.
        const int x = strip.at.x0 + i, y = strip.at.y;
        uncovered_[s].push_back({x, y, static_cast<int>(p), group[p].of(job.guide)(x, y), {}});
      }
      all_one = all_one && by == 1;
    }
    if (!all_one) scale_blocks({scale.data(), at(strip.at.blocks())}, job.row_of(strip, group[p]));
  }
  counted_[s].owed += static_cast<std::int64_t>(uncovered_[s].size());
}

/// Two passes: all fillings are found from the canvas as it is before any is written, for two
/// blocks side by side may both be uncovered.
void Lock::fill_uncovered_blocks(const Job& job, const Group& group) {
  const auto owes = [](const std::vector<UncoveredBlock>& blocks) { return !blocks.empty(); };
  if (std::none_of(uncovered_.begin(),
                   uncovered_.begin() + static_cast<std::ptrdiff_t>(strips_.size()), owes))
    return;
  for_strips(job, [&](std::size_t s) {
    for (UncoveredBlock& block : uncovered_[s])
      fill_uncovered(job.canvas, group[at(block.plane)], block);
  });
  for_strips(job, [&](std::size_t s) {
    for (const UncoveredBlock& block : uncovered_[s])
      store_uncovered(job.canvas, group[at(block.plane)], block);
  });
}

}  // namespace pentimento

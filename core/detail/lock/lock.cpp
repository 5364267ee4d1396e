#include "core/detail/lock/lock.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/detail/lock/lock_rows.h"
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
constexpr std::size_t kSharpenings = 2;  // a third would add to what goes up and down inside blocks
constexpr int kStripsPerTask = 8;        // whose layers are looked at
constexpr int kCellsPerTask = 4096;      // some microseconds, as in for_runs

/// The part of a strip that a ratio other than 1 reaches.
BlockStrip off_part(const RatiosAround& ratio, BlockStrip strip) {
  const int first = strip.x0;
  const auto off = [&](int block) {
    return ratio.at(0, block) != 1 || ratio.at(1, block) != 1 || ratio.at(2, block) != 1;
  };
  const auto reached = [&](int x) {
    const int block = x - first;
    return off(block) || off(block - 1) || off(block + 1);
  };
  while (strip.x0 < strip.x1 && !reached(strip.x0)) ++strip.x0;
  while (strip.x0 < strip.x1 && !reached(strip.x1 - 1)) --strip.x1;
  return strip;
}
}  // namespace

void Lock::lock(DetailCanvas& canvas, const CanvasState& guide,
                const std::vector<BlockStrip>& strips, const Threads& threads) {
  // Which strips to lock; how many of them, in one group of planes, make a task.
  list(canvas, strips);
  if (strips_.empty()) return;
  find_splits(canvas.layout(), threads);
  list_planes(canvas);
  reset_tables();
  const auto fine = blocks_ * static_cast<std::size_t>(canvas.layout().factor()) *
                    static_cast<std::size_t>(canvas.layout().factor());
  const auto cells = static_cast<int>(fine / strips_.size());
  const Job job{canvas, guide, threads, std::max(1, kCellsPerTask / std::max(1, cells))};
  const std::size_t groups = groups_.size();
  // What each block holds, and by which ratio it is off.
  for_parts(job, 0, groups, [&](std::size_t g, std::size_t s) {
    measure(job, g, s);
    find_ratios(job, g, s);
  });
  // The smooth field: what a block would hold under it is brought nearer to what it shall hold.
  const bool any_off = find_off_groups();
  for (std::size_t round = 0; round < kSharpenings && any_off; ++round)
    for_parts(job, 0, groups, [&](std::size_t g, std::size_t s) {
      if (group_is_off_[g] != 0) sharpen(job, g, s, round);
    });
  // The fine cells are multiplied by the field, so that no block shows its border; then, while they
  // are in the cache, what is still off is scaled block by block.
  for_parts(job, 0, groups, [&](std::size_t g, std::size_t s) {
    if (group_is_off_[g] != 0) smooth(job, g, s);
    make_exact(job, g, s);
  });
  // Blocks with next to nothing to scale are filled: pigment by the depth that is there then.
  fill_uncovered_blocks(job, 0, 1);
  fill_uncovered_blocks(job, 1, groups);
  // Each part counted for itself: the sums do not depend on the threads.
  for (const LockStatistics& s : counted_) {
    for (std::size_t i = 0; i < s.blocks.size(); ++i) statistics_.blocks[i] += s.blocks[i];
    statistics_.owed += s.owed;
  }
}

/// Lists the strips that have a tile.
void Lock::list(DetailCanvas& canvas, const std::vector<BlockStrip>& strips) {
  strips_.clear();
  blocks_ = 0;
  for (BlockRatios& ratio : ratio_) ratio.clear();
  for (const BlockStrip& at : strips) {
    DetailTile* tile = canvas.find(at.tile);
    if (tile == nullptr) continue;
    strips_.push_back({at, tile, blocks_});
    blocks_ += static_cast<std::size_t>(at.blocks());
    for (BlockRatios& ratio : ratio_) ratio.add(at);
  }
}

/// Finds for each block whether its layers are those of the guide's cell.
void Lock::find_splits(const DetailLayout& layout, const Threads& threads) {
  split_.resize(blocks_);
  threads.for_ranges(0, static_cast<int>(strips_.size()), kStripsPerTask, [&](int begin, int end) {
    for (std::size_t s = at(begin); s < at(end); ++s) {
      Strip& strip = strips_[s];
      for (int x = strip.at.x0; x < strip.at.x1; ++x) {
        const bool splits = !layers_correspond(*strip.tile, layout, x, strip.at.y);
        split_[strip.first + at(x - strip.at.x0)] = splits ? 1 : 0;
        strip.is_split |= splits;
      }
    }
  });
}

/// The depth alone; then each pigment channel with all its layers, for a mismatched block is locked
/// as the sum of its layers.
void Lock::list_planes(const DetailCanvas& canvas) {
  planes_ = {WetPlane{}};
  groups_ = {{0, 1}};
  for (int c = 0; c < canvas.channels(); ++c) {
    for (int layer = 0; layer < canvas.layers(); ++layer)
      planes_.push_back(WetPlane{layer * canvas.channels() + c});
    groups_.push_back({groups_.back().end, planes_.size()});
  }
}

void Lock::reset_tables() {
  const std::size_t parts = groups_.size() * strips_.size();
  for (BlockRatios& ratio : ratio_) ratio.reset(planes_.size());
  held_.assign(planes_.size() * blocks_, 0.0f);
  wants_.assign(planes_.size() * strips_.size(), 0);
  holds_.assign(planes_.size() * strips_.size(), 0);
  off_.assign(parts, 0);
  counted_.assign(parts, {});
  if (uncovered_.size() < parts) uncovered_.resize(parts);
}

/// Calls body(group, strip) for the groups from `first_group` to before `end_group` and all strips.
template <typename Body>
void Lock::for_parts(const Job& job, std::size_t first_group, std::size_t end_group,
                     const Body& body) {
  const std::size_t strips = strips_.size();
  job.threads.for_ranges(static_cast<int>(first_group * strips),
                         static_cast<int>(end_group * strips), job.grain_size,
                         [&](int begin, int end) {
                           for (int part = begin; part < end; ++part)
                             body(at(part) / strips, at(part) % strips);
                         });
}

/// What the blocks of a strip hold, and whether there is anything to compare.
void Lock::measure(const Job& job, std::size_t g, std::size_t s) {
  const Strip& strip = strips_[s];
  for (std::size_t p = groups_[g].begin; p < groups_[g].end; ++p) {
    const float* wanted = planes_[p].of(job.guide).row(strip.at.y) + strip.at.x0;
    wants_[p * strips_.size() + s] = any_not_zero(wanted, strip.at.blocks()) ? 1 : 0;
    if (!planes_[p].of(*strip.tile)) continue;
    const std::span<float> held = held_of(p, strip);
    block_means(job.row_of(strip, planes_[p]), held);
    holds_[p * strips_.size() + s] = any_not_zero(held.data(), strip.at.blocks()) ? 1 : 0;
  }
}

/// A flag of a plane in a strip; where blocks are mismatched, of all planes of the group.
bool Lock::any(const std::vector<std::uint8_t>& flags, const Group& group, std::size_t plane,
               std::size_t s) const {
  const std::size_t strips = strips_.size();
  if (!strips_[s].is_split) return flags[plane * strips + s] != 0;
  for (std::size_t p = group.begin; p < group.end; ++p)
    if (flags[p * strips + s] != 0) return true;
  return false;
}

/// Finds the groups that are off somewhere. False if there are none.
bool Lock::find_off_groups() {
  group_is_off_.assign(groups_.size(), 0);
  for (std::size_t part = 0; part < groups_.size() * strips_.size(); ++part)
    if (off_[part] != 0) group_is_off_[part / strips_.size()] = 1;
  return std::any_of(group_is_off_.begin(), group_is_off_.end(),
                     [](std::uint8_t off) { return off != 0; });
}

/// Multiplies the fine cells of a strip by the smooth field. Keeps `held_` up to date.
void Lock::smooth(const Job& job, std::size_t g, std::size_t s) {
  const Strip& strip = strips_[s];
  RatiosAround ratio;
  for (std::size_t p = groups_[g].begin; p < groups_[g].end; ++p) {
    if (holds_[p * strips_.size() + s] == 0) continue;
    ratio_[kSharpenings % 2].read(p, strip.at, ratio);
    const BlockStrip part = off_part(ratio, strip.at);
    if (part.blocks() <= 0) continue;
    const int first = part.x0 - strip.at.x0;
    scale_by_field(ratio.from(first),
                   block_row(planes_[p].of(*strip.tile).data(), job.canvas.layout(), part),
                   held_of(p, strip).subspan(at(first), at(part.blocks())));
  }
}

/// What the guide wants in the blocks of a strip and what they hold: of one plane, or in a
/// mismatched block of all layers of a pigment channel. `sums` has room for the latter.
BlockTargets Lock::targets_of(const Job& job, const Group& group, std::size_t plane,
                              const Strip& strip, TargetSums& sums) const {
  const auto wanted = [&](std::size_t p) {
    return planes_[p].of(job.guide).row(strip.at.y) + strip.at.x0;
  };
  const auto held = [&](std::size_t p) { return held_.data() + p * blocks_ + strip.first; };
  if (!strip.is_split || group.end == group.begin + 1) return {wanted(plane), held(plane)};
  for (std::size_t i = 0; i < at(strip.at.blocks()); ++i) {
    const bool alone = split_[strip.first + i] == 0;
    sums.wanted[i] = alone ? wanted(plane)[i] : 0.0f;
    sums.held[i] = alone ? held(plane)[i] : 0.0f;
    for (std::size_t p = group.begin; p < group.end && !alone; ++p) {
      sums.wanted[i] += wanted(p)[i];
      sums.held[i] += held(p)[i];
    }
  }
  return {sums.wanted.data(), sums.held.data()};
}

/// By which ratio each block is off, and whether any of a strip is.
void Lock::find_ratios(const Job& job, std::size_t g, std::size_t s) {
  const Strip& strip = strips_[s];
  const int n = strip.at.blocks();
  const std::size_t here = g * strips_.size() + s;
  TargetSums sums;
  for (std::size_t p = groups_[g].begin; p < groups_[g].end; ++p) {
    // Otherwise the ratios are 1, and stay so.
    if (!any(wants_, groups_[g], p, s) || !any(holds_, groups_[g], p, s)) continue;
    const BlockTargets to = targets_of(job, groups_[g], p, strip, sums);
    count_ratios(to, n, counted_[here].blocks);
    if (ratio_row(to, n, ratio_[0].of(p, strip.first, at(n)).data())) off_[here] = 1;
  }
}

/// Sharpens the field in a strip. Reads one table of ratios and writes the other.
void Lock::sharpen(const Job& job, std::size_t g, std::size_t s, std::size_t round) {
  const Strip& strip = strips_[s];
  const int n = strip.at.blocks();
  const float own = share_of_own_centre(job.canvas.layout().factor());
  TargetSums sums;
  RatiosAround field;
  for (std::size_t p = groups_[g].begin; p < groups_[g].end; ++p) {
    if (!any(wants_, groups_[g], p, s) || !any(holds_, groups_[g], p, s)) continue;
    ratio_[round % 2].read(p, strip.at, field);
    float* out = ratio_[(round + 1) % 2].of(p, strip.first, at(n)).data();
    if (off_part(field, strip.at).blocks() <= 0) {
      std::fill_n(out, n, 1.0f);
    } else {
      const BlockTargets to = targets_of(job, groups_[g], p, strip, sums);
      sharpen_row(to, field.from(0), own, n, out);
    }
  }
}

void Lock::make_exact(const Job& job, std::size_t g, std::size_t s) {
  const Strip& strip = strips_[s];
  const Group& group = groups_[g];
  const int n = strip.at.blocks();
  const std::size_t here = g * strips_.size() + s;
  uncovered_[here].clear();
  TargetSums sums;
  std::array<float, kMostTileSide> scale;
  std::array<std::uint8_t, kMostTileSide> owed;
  for (std::size_t p = group.begin; p < group.end; ++p) {
    if (!planes_[p].of(*strip.tile)) continue;
    if (!any(wants_, group, p, s) && !any(holds_, group, p, s)) continue;
    const BlockTargets to = targets_of(job, group, p, strip, sums);
    const bool scales = exact_row(to, n, scale.data(), owed.data());
    // Fill up to what the guide has in this very layer, even if the block's layers are mismatched.
    for (int i = 0; i < n; ++i)
      if (owed[at(i)] != 0)
        uncovered_[here].push_back({strip.at.x0 + i,
                                    strip.at.y,
                                    static_cast<int>(p),
                                    planes_[p].of(job.guide)(strip.at.x0 + i, strip.at.y),
                                    {}});
    if (scales) scale_blocks({scale.data(), at(n)}, job.row_of(strip, planes_[p]));
  }
  counted_[here].owed += static_cast<std::int64_t>(uncovered_[here].size());
}

/// Two passes: all fillings are found from the canvas as it is before any is written, for two
/// blocks side by side may both be uncovered.
void Lock::fill_uncovered_blocks(const Job& job, std::size_t first_group, std::size_t end_group) {
  const std::size_t strips = strips_.size();
  bool owes = false;
  for (std::size_t part = first_group * strips; part < end_group * strips; ++part)
    owes |= !uncovered_[part].empty();
  if (!owes) return;
  for_parts(job, first_group, end_group, [&](std::size_t g, std::size_t s) {
    for (UncoveredBlock& block : uncovered_[g * strips + s])
      fill_uncovered(job.canvas, planes_[at(block.plane)], block);
  });
  for_parts(job, first_group, end_group, [&](std::size_t g, std::size_t s) {
    for (const UncoveredBlock& block : uncovered_[g * strips + s])
      store_uncovered(job.canvas, planes_[at(block.plane)], block);
  });
}

}  // namespace pentimento

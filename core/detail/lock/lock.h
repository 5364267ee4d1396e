#pragma once
// The lock: it makes every block of fine cells hold, in depth and in every pigment, just what the
// guide's cell holds. First it scales by a field of ratios that is interpolated between cells, so
// that no block shows. Then it scales what is still off block by block.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/threads.h"
#include "core/detail/lock/block_ratios.h"
#include "core/detail/lock/lock_rows.h"
#include "core/detail/lock/uncovered_blocks.h"
#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// How far the blocks were off before the lock: counts of |guide / detail - 1| by bins, over depth
/// and pigments.
struct LockStatistics {
  static constexpr std::array<float, 7> kBound = kRatioBounds;
  RatioCounts blocks{};
  std::int64_t owed = 0;  // uncovered blocks
};

class Lock {
 public:
  explicit Lock(const DetailLayout& layout) : ratio_{BlockRatios(layout), BlockRatios(layout)} {}

  /// Locks the blocks of `strips` (ChangedBlocks::strips()) to the guide; all others are locked
  /// already.
  ///   r = guide / block mean, 1 where either is 0 or r beyond [1/2, 2]
  ///   2 times: r *= guide / (block mean * mean of bilinear r over the block)
  ///   value *= bilinear r
  ///   then value *= guide / block mean, whatever that is; blocks that owe more than 16 times what
  ///   they hold are filled (uncovered_blocks.h)
  /// This is done for each layer of a pigment. In mismatched blocks (open_cells.h) it is done for
  /// the sum over the layers, with one ratio for all.
  /// Scheme: multiplicative, so nothing becomes negative and bare cells stay bare. The smooth field
  ///   is found as if the cells of a block were alike, so that fine cells are read twice and
  ///   written once (ADR 36).
  /// Stable: the last ratio is exact; the first are bounded.
  /// Source: docs/fidelity.md. Departs from it: blocks outside the list count as ratio 1, so list
  /// the neighbours of what changed.
  void lock(DetailCanvas& canvas, const CanvasState& guide, const std::vector<BlockStrip>& strips,
            const Threads& threads);

  const LockStatistics& statistics() const { return statistics_; }
  /// Goes on counting from there.
  void recall(const LockStatistics& statistics) { statistics_ = statistics; }

 private:
  struct Job;
  /// Blocks [x0, x1) of a row in an existing tile.
  struct Strip {
    BlockStrip at;
    DetailTile* tile = nullptr;
    std::size_t first = 0;  // index of its first block in the tables
    bool is_split = false;  // whether any of its blocks is mismatched
  };
  /// Planes that are locked together, by their indices: the depth alone, or one pigment in all its
  /// layers.
  struct Group {
    std::size_t begin = 0, end = 0;
  };
  struct TargetSums {
    std::array<float, kMostTileSide> wanted, held;
  };
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::span<float> held_of(std::size_t plane, const Strip& strip) {
    return {held_.data() + plane * blocks_ + strip.first, at(strip.at.blocks())};
  }
  void list(DetailCanvas& canvas, const std::vector<BlockStrip>& strips);
  void find_splits(const DetailLayout& layout, const Threads& threads);
  void list_planes(const DetailCanvas& canvas);
  void reset_tables();
  template <typename Body>
  void for_parts(const Job& job, std::size_t first_group, std::size_t end_group, const Body& body);
  void measure(const Job& job, std::size_t g, std::size_t s);
  bool any(const std::vector<std::uint8_t>& flags, const Group& group, std::size_t plane,
           std::size_t s) const;
  bool find_off_groups();
  void smooth(const Job& job, std::size_t g, std::size_t s);
  BlockTargets targets_of(const Job& job, const Group& group, std::size_t plane, const Strip& strip,
                          TargetSums& sums) const;
  void find_ratios(const Job& job, std::size_t g, std::size_t s);
  void sharpen(const Job& job, std::size_t g, std::size_t s, std::size_t round);
  void make_exact(const Job& job, std::size_t g, std::size_t s);
  void fill_uncovered_blocks(const Job& job, std::size_t first_group, std::size_t end_group);

  std::vector<Strip> strips_;
  std::vector<WetPlane> planes_;
  std::vector<Group> groups_;  // the depth first
  std::size_t blocks_ = 0;
  std::array<BlockRatios, 2> ratio_;  // of the field; sharpening reads one and writes the other
  std::vector<float> held_;           // mean of each block, plane after plane
  std::vector<std::uint8_t> split_;   // per block: 1 if mismatched
  // Plane after plane, per strip: whether the guide wants anything there, and whether the blocks
  // hold anything.
  std::vector<std::uint8_t> wants_, holds_;
  // Group after group, per strip.
  std::vector<std::uint8_t> off_;  // 1 if it has a ratio that is not 1
  std::vector<LockStatistics> counted_;
  std::vector<std::vector<UncoveredBlock>> uncovered_;
  std::vector<std::uint8_t> group_is_off_;
  LockStatistics statistics_;
};

}  // namespace pentimento

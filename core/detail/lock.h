#pragma once
// The lock: every block of fine cells holds, in depth and in every pigment, just what the guide's
// cell holds. First by a field of ratios interpolated between cells, which shows no blocks, then
// by what is left, block by block.

#include <array>
#include <cstdint>
#include <vector>

#include "core/detail/detail_canvas.h"
#include "core/detail/owed_blocks.h"
#include "core/threads.h"

namespace pentimento {

/// How far the ratios guide / detail of blocks were from 1 before the lock, over depth and
/// pigments: counts per bin of |ratio - 1|.
struct LockStatistics {
  static constexpr std::array<float, 7> kBound = {0.001f, 0.003f, 0.01f, 0.03f, 0.1f, 0.3f, 1.0f};
  std::array<std::int64_t, 8> blocks{};  // the last: beyond all bounds
  std::int64_t owed = 0;                 // blocks without paint of their own
};

class Lock {
 public:
  Lock(const DetailLayout& layout, int layers);

  /// Locks the tiles (ascending, each once) to the guide; the others are locked already.
  ///   3 times: r = guide / block mean, within [1/4, 4], 1 where either is 0; value *= bilinear r
  ///   then value *= guide / block mean, whatever that is; blocks that owe more than 16 times what
  ///   they hold are filled (owed_blocks.h)
  /// per layer of a pigment; of its sum over layers, the same ratio for all, where the layers do
  /// not correspond (open_cells.h).
  /// Scheme: multiplicative, so nothing becomes negative and bare cells stay bare.
  /// Stable: the last ratio is exact; the first are bounded.
  /// Source: docs/fidelity.md. Departs from it: tiles outside the list count as ratio 1.
  void lock(DetailCanvas& canvas, const CanvasState& guide, const std::vector<int>& tiles,
            const Threads& threads);

  const LockStatistics& statistics() const { return statistics_; }

 private:
  /// What is locked together: the depth alone, or one pigment in all its layers.
  using Group = std::vector<WetPlane>;
  struct Job;
  void lock_group(const Job& job, const Group& group);
  bool find_ratios(const Job& job, const Group& group, bool count);
  void make_exact(const Job& job, const Group& group);

  std::vector<Field<float>> ratio_;  // per plane of a group, of the guide's size; 1 between calls
  std::vector<std::vector<std::uint8_t>> split_;  // per tile: blocks whose layers differ
  std::vector<std::uint8_t> off_;
  std::vector<LockStatistics> counted_;
  std::vector<std::vector<OwedBlock>> owed_;
  LockStatistics statistics_;
};

}  // namespace pentimento

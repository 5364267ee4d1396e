#pragma once
// Which blocks may no longer hold what the guide holds. More blocks are listed as changed than are:
// the guide rounds all cells in a box around the brush, and changes few of them. To lock a block
// reads all of its fine cells, to compare a cell of the guide with what it held reads one value.

#include <cstdint>
#include <vector>

#include "core/base/field.h"
#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/detail/store/changed_blocks.h"

namespace pentimento {

/// Not thread-safe.
class StaleBlocks {
 public:
  /// The guide has no wet paint, and neither has the detail canvas.
  StaleBlocks(const DetailLayout& layout, int layers, int channels);

  /// The strips of `changed` in which the guide holds something else than when they were noted, or
  /// whose fine cells were `reworked`, with the blocks of `changed` next to them, for the lock
  /// needs those (lock.h). Blocks between two strips that are hardly apart are added. Notes the
  /// guide's cells of `changed`.
  std::vector<BlockStrip> find(const CanvasState& guide, const ChangedBlocks& changed,
                               const ChangedBlocks& reworked, const Threads& threads);
  /// Notes all cells: the detail canvas holds what the guide holds.
  void note(const CanvasState& guide);
  /// Neither holds wet paint any more.
  void clear();

 private:
  void add_near(const BlockStrip& strip, std::vector<BlockStrip>& found);

  std::vector<Field<float>> held_;  // depth, then pigment as [layer * channels + channel]
  Field<std::uint8_t> stale_;       // 1 where a block is stale; all 0 between calls
  std::vector<std::uint8_t> near_;  // of a row
};

}  // namespace pentimento

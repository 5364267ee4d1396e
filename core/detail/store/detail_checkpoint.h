#pragma once
// The checkpoint: what the detail canvas keeps from step to step beside its planes, as tables of
// whole numbers. With the planes it is all that a replay needs to go on as if it had never stopped.

#include <cstdint>
#include <vector>

#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/released_blocks.h"

namespace pentimento {

/// Columns of DetailCheckpoint::tile. From kCheckpointDepth on, 1 says that the plane exists.
enum TileColumn : int {
  kCheckpointMade,   // 1: the tile exists
  kCheckpointRest,   // 0: already searched for planes to free; else 1 + steps since the lock
  kCheckpointDried,  // 1: the tile has reflectance
  kCheckpointDepth,
  kCheckpointPigment  // and on: [layer * channels + channel]
};

/// Bits of DetailCheckpoint::block. The first 24 say to which layer each layer goes, three bits
/// each.
inline constexpr int kCheckpointLayerBits = 3;
inline constexpr std::uint32_t kCheckpointMerges = 1u << 24;  // then the bottom two become one
inline constexpr std::uint32_t kCheckpointMismatched = 1u
                                                       << 25;  // layers do not correspond any more
inline constexpr std::uint32_t kCheckpointChanged = 1u << 26;  // since the last lock

struct DetailCheckpoint {
  std::vector<std::uint32_t> tile;     // per tile of the layout: kCheckpointPigment + planes values
  std::vector<std::uint32_t> block;    // per cell of the guide, row by row
  std::vector<std::uint32_t> waiting;  // per cell of the guide: a bit per fine cell, 1 = waits
  std::vector<StampedBlock> stamped;   // blocks that the brush was over lately

  friend bool operator==(const DetailCheckpoint&, const DetailCheckpoint&) = default;
};

/// How many values `waiting` has for each cell of the guide. Fine cell (x, y) of a block is bit (y
/// factor + x) % 32 of value (y factor + x) / 32.
constexpr int waiting_words(int factor) {
  return (factor * factor + 31) / 32;
}

/// Tables for `layout` and `planes` (layers * channels), all 0.
DetailCheckpoint make_checkpoint(const DetailLayout& layout, int planes);

/// The checkpoint of a canvas: its tiles (all but kCheckpointRest) and its open cells.
DetailCheckpoint checkpoint_canvas(const DetailCanvas& canvas);
/// The open cells of a tile, from a checkpoint.
OpenCells restore_open_cells(const DetailCheckpoint& checkpoint, const DetailLayout& layout,
                             int tile);

/// Writes the changed blocks into a checkpoint, and reads them back.
void checkpoint_changed(const ChangedBlocks& changed, const DetailLayout& layout,
                        DetailCheckpoint& checkpoint);
void restore_changed(const DetailCheckpoint& checkpoint, const DetailLayout& layout,
                     ChangedBlocks& changed);

}  // namespace pentimento

#pragma once
// What the finer canvas keeps from one step to the next beside its planes, as tables of whole
// numbers: with the planes, all that it takes to go on as if nothing had happened.

#include <cstdint>
#include <vector>

#include "core/detail/store/changed_blocks.h"
#include "core/detail/store/detail_canvas.h"
#include "core/detail/store/left_blocks.h"

namespace pentimento {

/// Columns of DetailNotes::tile; from kNotedDepth on 1 says that the plane exists.
enum TileColumn : int {
  kNotedMade,   // 1: the tile exists
  kNotedRest,   // 0: looked through for planes to free; else 1 + steps since it was locked
  kNotedDried,  // 1: it has reflectance
  kNotedDepth,
  kNotedPigment  // and on: [layer * channels + channel]
};

/// Bits of DetailNotes::block. The first 24: to which layer each layer goes, three bits each.
inline constexpr int kNotedLayerBits = 3;
inline constexpr std::uint32_t kNotedMerges = 1u << 24;   // then the bottom two become one
inline constexpr std::uint32_t kNotedTangled = 1u << 25;  // layers do not correspond any more
inline constexpr std::uint32_t kNotedChanged = 1u << 26;  // since the last lock

struct DetailNotes {
  std::vector<std::uint32_t> tile;     // per tile of the layout: kNotedPigment + planes values
  std::vector<std::uint32_t> block;    // per cell of the guide, row by row
  std::vector<std::uint32_t> waiting;  // per cell of the guide: one bit per fine cell, 1 = waits
  std::vector<StampedBlock> left;      // that the brush was over lately

  friend bool operator==(const DetailNotes&, const DetailNotes&) = default;
};

/// Values in `waiting` per cell of the guide: fine cell (x, y) of the block is bit
/// (y factor + x) % 32 of value (y factor + x) / 32.
constexpr int waiting_words(int factor) {
  return (factor * factor + 31) / 32;
}

/// Tables of the sizes that `layout` and `planes` (layers * channels) ask for, all 0.
DetailNotes make_notes(const DetailLayout& layout, int planes);

/// Notes of tiles (all but kNotedRest) and of open cells.
DetailNotes note_canvas(const DetailCanvas& canvas);
/// The tile's open cells as they were noted.
OpenCells recall_open_cells(const DetailNotes& notes, const DetailLayout& layout, int tile);

void note_changed(const ChangedBlocks& changed, const DetailLayout& layout, DetailNotes& notes);
void recall_changed(const DetailNotes& notes, const DetailLayout& layout, ChangedBlocks& changed);

}  // namespace pentimento

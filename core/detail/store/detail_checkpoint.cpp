#include "core/detail/store/detail_checkpoint.h"

#include <algorithm>

#include "core/detail/store/open_cells.h"

namespace pentimento {

namespace {
std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

std::size_t cell_of(const DetailLayout& layout, int x, int y) {
  return at(y) * at(layout.guide().width) + at(x);
}

std::uint32_t bits_of(const LayerOpening& opening) {
  std::uint32_t bits = opening.merges ? kCheckpointMerges : 0;
  for (int layer = 0; layer < kMaxLayers; ++layer)
    bits |= static_cast<std::uint32_t>(opening.to[at(layer)]) << (layer * kCheckpointLayerBits);
  return bits;
}

LayerOpening opening_from(std::uint32_t bits) {
  LayerOpening opening;
  opening.merges = (bits & kCheckpointMerges) != 0;
  for (int layer = 0; layer < kMaxLayers; ++layer)
    opening.to[at(layer)] = static_cast<std::int8_t>(bits >> (layer * kCheckpointLayerBits) & 7u);
  return opening;
}

/// Where a block lies among the blocks and the fine cells of its tile.
struct BlockPlace {
  std::size_t block = 0, cell = 0;  // cell: its first
};
BlockPlace place_in_tile(const DetailLayout& layout, int x, int y) {
  const int blocks = layout.blocks(), k = layout.factor();
  return {at(y % blocks * blocks + x % blocks),
          at(y % blocks * k) * at(layout.side()) + at(x % blocks * k)};
}

/// Calls body(bit, fine cell of the tile) for all cells of a block.
template <typename Body>
void for_cells(const DetailLayout& layout, const BlockPlace& place, const Body& body) {
  const int k = layout.factor();
  for (int j = 0; j < k; ++j)
    for (int i = 0; i < k; ++i) body(j * k + i, place.cell + at(j) * at(layout.side()) + at(i));
}

void checkpoint_block(const OpenCells& open, const DetailLayout& layout, int x, int y,
                      DetailCheckpoint& checkpoint) {
  const BlockPlace place = place_in_tile(layout, x, y);
  const std::size_t cell = cell_of(layout, x, y);
  std::uint32_t* waiting = checkpoint.waiting.data() + cell * at(waiting_words(layout.factor()));
  bool any = false;
  for_cells(layout, place, [&](int bit, std::size_t fine) {
    if (open.opened[fine] != 0) return;
    waiting[bit / 32] |= 1u << (bit % 32);
    any = true;
  });
  // Where all cells are open, what opening would do no longer matters.
  checkpoint.block[cell] = (any ? bits_of(open.opening[place.block]) : 0) |
                           (open.mismatched[place.block] != 0 ? kCheckpointMismatched : 0);
}

void checkpoint_tile(const DetailTile& tile, int planes, DetailCheckpoint& checkpoint) {
  std::uint32_t* row = checkpoint.tile.data() + at(tile.tile) * at(kCheckpointPigment + planes);
  row[kCheckpointMade] = 1;
  row[kCheckpointDried] = tile.reflectance.empty() ? 0 : 1;
  row[kCheckpointDepth] = tile.depth_m ? 1 : 0;
  for (int p = 0; p < planes; ++p) row[kCheckpointPigment + p] = tile.pigment[at(p)] ? 1 : 0;
}
}  // namespace

DetailCheckpoint make_checkpoint(const DetailLayout& layout, int planes) {
  const std::size_t cells = at(layout.guide().width) * at(layout.guide().height);
  DetailCheckpoint checkpoint;
  checkpoint.tile.assign(at(layout.tiles()) * at(kCheckpointPigment + planes), 0);
  checkpoint.block.assign(cells, 0);
  checkpoint.waiting.assign(cells * at(waiting_words(layout.factor())), 0);
  return checkpoint;
}

DetailCheckpoint checkpoint_canvas(const DetailCanvas& canvas) {
  const DetailLayout& layout = canvas.layout();
  const int planes = canvas.layers() * canvas.channels();
  DetailCheckpoint checkpoint = make_checkpoint(layout, planes);
  for (int t = 0; t < layout.tiles(); ++t) {
    const DetailTile* tile = canvas.find(t);
    if (tile == nullptr) continue;
    checkpoint_tile(*tile, planes, checkpoint);
    if (tile->open.empty()) continue;
    for (int y = tile->box.y0; y < tile->box.y1; ++y)
      for (int x = tile->box.x0; x < tile->box.x1; ++x)
        checkpoint_block(tile->open, layout, x, y, checkpoint);
  }
  return checkpoint;
}

OpenCells restore_open_cells(const DetailCheckpoint& checkpoint, const DetailLayout& layout,
                             int tile) {
  const CellBox box = layout.box(tile);
  const std::size_t words = at(waiting_words(layout.factor()));
  OpenCells open;
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) {
      const std::size_t cell = cell_of(layout, x, y);
      const std::uint32_t bits = checkpoint.block[cell] & ~kCheckpointChanged;
      const std::uint32_t* waiting = checkpoint.waiting.data() + cell * words;
      if (bits == 0 && std::all_of(waiting, waiting + words, [](auto w) { return w == 0; }))
        continue;
      make_openable(open, layout);
      const BlockPlace place = place_in_tile(layout, x, y);
      open.opening[place.block] = opening_from(bits);
      open.mismatched[place.block] = (bits & kCheckpointMismatched) != 0 ? 1 : 0;
      for_cells(layout, place, [&](int bit, std::size_t fine) {
        open.opened[fine] = (waiting[bit / 32] >> (bit % 32) & 1u) != 0 ? 0 : 1;
      });
    }
  return open;
}

void checkpoint_changed(const ChangedBlocks& changed, const DetailLayout& layout,
                        DetailCheckpoint& checkpoint) {
  for (const BlockStrip& strip : changed.strips())
    for (int x = strip.x0; x < strip.x1; ++x)
      checkpoint.block[cell_of(layout, x, strip.y)] |= kCheckpointChanged;
}

void restore_changed(const DetailCheckpoint& checkpoint, const DetailLayout& layout,
                     ChangedBlocks& changed) {
  for (int y = 0; y < layout.guide().height; ++y)
    for (int x = 0; x < layout.guide().width; ++x)
      if ((checkpoint.block[cell_of(layout, x, y)] & kCheckpointChanged) != 0)
        changed.add(y, x, x + 1);
}

}  // namespace pentimento

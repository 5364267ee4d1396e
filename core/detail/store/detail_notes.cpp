#include "core/detail/store/detail_notes.h"

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
  std::uint32_t bits = opening.merges ? kNotedMerges : 0;
  for (int layer = 0; layer < kMaxLayers; ++layer)
    bits |= static_cast<std::uint32_t>(opening.to[at(layer)]) << (layer * kNotedLayerBits);
  return bits;
}

LayerOpening opening_from(std::uint32_t bits) {
  LayerOpening opening;
  opening.merges = (bits & kNotedMerges) != 0;
  for (int layer = 0; layer < kMaxLayers; ++layer)
    opening.to[at(layer)] = static_cast<std::int8_t>(bits >> (layer * kNotedLayerBits) & 7u);
  return opening;
}

/// A block's place among its tile's blocks and fine cells.
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

void note_block(const OpenCells& open, const DetailLayout& layout, int x, int y,
                DetailNotes& notes) {
  const BlockPlace place = place_in_tile(layout, x, y);
  const std::size_t cell = cell_of(layout, x, y);
  std::uint32_t* waiting = notes.waiting.data() + cell * at(waiting_words(layout.factor()));
  bool any = false;
  for_cells(layout, place, [&](int bit, std::size_t fine) {
    if (open.opened[fine] != 0) return;
    waiting[bit / 32] |= 1u << (bit % 32);
    any = true;
  });
  // What opening would do no longer matters where all are open.
  notes.block[cell] = (any ? bits_of(open.opening[place.block]) : 0) |
                      (open.tangled[place.block] != 0 ? kNotedTangled : 0);
}

void note_tile(const DetailTile& tile, int planes, DetailNotes& notes) {
  std::uint32_t* row = notes.tile.data() + at(tile.tile) * at(kNotedPigment + planes);
  row[kNotedMade] = 1;
  row[kNotedDried] = tile.reflectance.empty() ? 0 : 1;
  row[kNotedDepth] = tile.depth_m ? 1 : 0;
  for (int p = 0; p < planes; ++p) row[kNotedPigment + p] = tile.pigment[at(p)] ? 1 : 0;
}
}  // namespace

DetailNotes make_notes(const DetailLayout& layout, int planes) {
  const std::size_t cells = at(layout.guide().width) * at(layout.guide().height);
  DetailNotes notes;
  notes.tile.assign(at(layout.tiles()) * at(kNotedPigment + planes), 0);
  notes.block.assign(cells, 0);
  notes.waiting.assign(cells * at(waiting_words(layout.factor())), 0);
  return notes;
}

DetailNotes note_canvas(const DetailCanvas& canvas) {
  const DetailLayout& layout = canvas.layout();
  const int planes = canvas.layers() * canvas.channels();
  DetailNotes notes = make_notes(layout, planes);
  for (int t = 0; t < layout.tiles(); ++t) {
    const DetailTile* tile = canvas.find(t);
    if (tile == nullptr) continue;
    note_tile(*tile, planes, notes);
    if (tile->open.empty()) continue;
    for (int y = tile->box.y0; y < tile->box.y1; ++y)
      for (int x = tile->box.x0; x < tile->box.x1; ++x) note_block(tile->open, layout, x, y, notes);
  }
  return notes;
}

OpenCells recall_open_cells(const DetailNotes& notes, const DetailLayout& layout, int tile) {
  const CellBox box = layout.box(tile);
  const std::size_t words = at(waiting_words(layout.factor()));
  OpenCells open;
  for (int y = box.y0; y < box.y1; ++y)
    for (int x = box.x0; x < box.x1; ++x) {
      const std::size_t cell = cell_of(layout, x, y);
      const std::uint32_t bits = notes.block[cell] & ~kNotedChanged;
      const std::uint32_t* waiting = notes.waiting.data() + cell * words;
      if (bits == 0 && std::all_of(waiting, waiting + words, [](auto w) { return w == 0; }))
        continue;
      make_openable(open, layout);
      const BlockPlace place = place_in_tile(layout, x, y);
      open.opening[place.block] = opening_from(bits);
      open.tangled[place.block] = (bits & kNotedTangled) != 0 ? 1 : 0;
      for_cells(layout, place, [&](int bit, std::size_t fine) {
        open.opened[fine] = (waiting[bit / 32] >> (bit % 32) & 1u) != 0 ? 0 : 1;
      });
    }
  return open;
}

void note_changed(const ChangedBlocks& changed, const DetailLayout& layout, DetailNotes& notes) {
  for (const BlockStrip& strip : changed.strips())
    for (int x = strip.x0; x < strip.x1; ++x)
      notes.block[cell_of(layout, x, strip.y)] |= kNotedChanged;
}

void recall_changed(const DetailNotes& notes, const DetailLayout& layout, ChangedBlocks& changed) {
  for (int y = 0; y < layout.guide().height; ++y)
    for (int x = 0; x < layout.guide().width; ++x)
      if ((notes.block[cell_of(layout, x, y)] & kNotedChanged) != 0) changed.add(y, x, x + 1);
}

}  // namespace pentimento

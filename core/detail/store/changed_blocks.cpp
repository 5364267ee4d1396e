#include "core/detail/store/changed_blocks.h"

namespace pentimento {

ChangedBlocks::ChangedBlocks(const DetailLayout& layout)
    : layout_(layout),
      span_(static_cast<std::size_t>(layout.columns()) *
            static_cast<std::size_t>(layout.guide().height)),
      flag_(static_cast<std::size_t>(layout.tiles()), 0) {}

void ChangedBlocks::add(int y, int x0, int x1) {
  const CanvasGeometry& guide = layout_.guide();
  x0 = std::max(x0, 0);
  x1 = std::min(x1, guide.width);
  if (y < 0 || y >= guide.height || x0 >= x1) return;
  const int blocks = layout_.blocks();
  for (int column = x0 / blocks; column * blocks < x1; ++column) {
    ChangedSpan& s =
        span_[static_cast<std::size_t>(column) * static_cast<std::size_t>(guide.height) +
              static_cast<std::size_t>(y)];
    const int first = std::max(x0, column * blocks), last = std::min(x1, (column + 1) * blocks);
    s.x0 = s.x1 == 0 ? first : std::min(s.x0, first);
    s.x1 = std::max(s.x1, last);
    const int tile = layout_.tile_of(column, y / blocks);
    std::uint8_t& flag = flag_[static_cast<std::size_t>(tile)];
    if (flag == 0) listed_.push_back(tile);
    flag = 1;
  }
}

void ChangedBlocks::add(const CellBox& box) {
  for (int y = box.y0; y < box.y1; ++y) add(y, box.x0, box.x1);
}

void ChangedBlocks::clear() {
  for (const int tile : listed_) {
    const CellBox box = layout_.box(tile);
    const std::size_t first = static_cast<std::size_t>(tile % layout_.columns()) *
                              static_cast<std::size_t>(layout_.guide().height);
    std::fill(span_.begin() + static_cast<std::ptrdiff_t>(first) + box.y0,
              span_.begin() + static_cast<std::ptrdiff_t>(first) + box.y1, ChangedSpan{});
    flag_[static_cast<std::size_t>(tile)] = 0;
  }
  listed_.clear();
}

std::vector<int> ChangedBlocks::tiles() const {
  std::vector<int> tiles = listed_;
  std::sort(tiles.begin(), tiles.end());
  return tiles;
}

std::vector<BlockStrip> ChangedBlocks::strips() const {
  std::vector<BlockStrip> strips;
  for (const int tile : tiles()) {
    const CellBox box = layout_.box(tile);
    for (int y = box.y0; y < box.y1; ++y) {
      const ChangedSpan& s = span(tile % layout_.columns(), y);
      if (s.x1 != 0) strips.push_back({tile, y, s.x0, s.x1});
    }
  }
  return strips;
}

CellBox ChangedBlocks::box(int tile) const {
  const CellBox whole = layout_.box(tile);
  CellBox box{whole.x1, whole.x0, whole.y1, whole.y0};
  for (int y = whole.y0; y < whole.y1; ++y) {
    const ChangedSpan& s = span(tile % layout_.columns(), y);
    if (s.x1 == 0) continue;
    box.x0 = std::min(box.x0, s.x0);
    box.x1 = std::max(box.x1, s.x1);
    box.y0 = std::min(box.y0, y);
    box.y1 = y + 1;
  }
  return box;
}

}  // namespace pentimento

#include "core/detail/store/open_cells.h"

#include <algorithm>

namespace pentimento {

namespace {
std::size_t block_of(const DetailLayout& layout, int x, int y) {
  const int blocks = layout.blocks();
  return static_cast<std::size_t>(y % blocks * blocks + x % blocks);
}

std::uint8_t* cells_of(DetailTile& tile, const DetailLayout& layout, int x, int y) {
  const int side = layout.side();
  return tile.open.opened.data() + static_cast<std::ptrdiff_t>(y % side) * side + x % side;
}

bool all_open(const DetailTile& tile, const DetailLayout& layout, int x, int y) {
  const int k = layout.factor(), side = layout.side(), blocks = layout.blocks();
  const std::uint8_t* first =
      tile.open.opened.data() + static_cast<std::ptrdiff_t>(y % blocks * k) * side + x % blocks * k;
  for (int j = 0; j < k; ++j, first += side)
    if (std::find(first, first + k, std::uint8_t{0}) != first + k) return false;
  return true;
}
}  // namespace

void make_openable(OpenCells& open, const DetailLayout& layout) {
  if (!open.empty()) return;
  const std::size_t side = static_cast<std::size_t>(layout.side());
  const std::size_t blocks = static_cast<std::size_t>(layout.blocks());
  open.opened.assign(side * side, 1);
  open.opening.resize(blocks * blocks);
  open.mismatched.assign(blocks * blocks, 0);
}

void await_tip(DetailTile& tile, const DetailLayout& layout, int x, int y, int layers,
               const LayerOpening& opening) {
  if (layers == 1) return;
  const int k = layout.factor();
  const std::size_t block = block_of(layout, x, y);
  // If a cell has two layers and they become one, they match the guide's again, whether the fine
  // cell opened a layer for the last stroke or not. With more layers, or if not all were full, fine
  // cells that did not open stay one layer behind.
  const bool joins_all = opening.merges && layers == 2;
  if (joins_all) {
    tile.open.mismatched[block] = 0;
  } else if (!all_open(tile, layout, x, y)) {
    tile.open.mismatched[block] = 1;
  }
  tile.open.opening[block] = opening;
  for (int j = 0; j < k; ++j)
    std::fill_n(cells_of(tile, layout, x * k, y * k + j), k, std::uint8_t{0});
}

const LayerOpening& opening_in(const DetailTile& tile, const DetailLayout& layout, int x, int y) {
  return tile.open.opening[block_of(layout, x, y)];
}

bool layers_correspond(const DetailTile& tile, const DetailLayout& layout, int x, int y) {
  if (tile.open.empty()) return true;
  return tile.open.mismatched[block_of(layout, x, y)] == 0 && all_open(tile, layout, x, y);
}

}  // namespace pentimento

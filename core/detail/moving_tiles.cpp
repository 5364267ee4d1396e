#include "core/detail/moving_tiles.h"

namespace pentimento {

namespace {
bool any_moves(const PaintEdges& edges, int y, int x0, int x1) {
  for (const auto* axis : {&edges.x, &edges.y}) {
    for (const Field<float>& plane : *axis) {
      const float* row = plane.row(y);
      for (int x = x0; x < x1; ++x)
        if (row[x] != 0) return true;
    }
  }
  return false;
}
}  // namespace

void spread_flags(const DetailLayout& layout, std::vector<std::uint8_t>& flag) {
  const std::vector<std::uint8_t> before = flag;
  for (int row = 0; row < layout.rows(); ++row) {
    for (int column = 0; column < layout.columns(); ++column) {
      if (before[static_cast<std::size_t>(layout.tile_of(column, row))] == 0) continue;
      for (int r = std::max(0, row - 1); r <= std::min(layout.rows() - 1, row + 1); ++r)
        for (int c = std::max(0, column - 1); c <= std::min(layout.columns() - 1, column + 1); ++c)
          flag[static_cast<std::size_t>(layout.tile_of(c, r))] = 1;
    }
  }
}

std::vector<std::uint8_t> moving_tiles(const DetailLayout& layout, const PaintEdges& edges,
                                       const std::vector<conservative::Run>& runs) {
  std::vector<std::uint8_t> flag(static_cast<std::size_t>(layout.tiles()), 0);
  const int blocks = layout.blocks();
  bool any = false;
  for (const conservative::Run& run : runs) {
    const int row = run.y / blocks;
    for (int column = run.x0 / blocks; column * blocks < run.x1; ++column) {
      std::uint8_t& f = flag[static_cast<std::size_t>(layout.tile_of(column, row))];
      if (f != 0) continue;
      const int x0 = std::max(run.x0, column * blocks);
      const int x1 = std::min(run.x1, (column + 1) * blocks);
      f = any_moves(edges, run.y, x0, x1) ? 1 : 0;
      any |= f != 0;
    }
  }
  if (any) spread_flags(layout, flag);
  return flag;
}

}  // namespace pentimento

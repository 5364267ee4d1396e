#include "core/detail/store/tile_line.h"

#include <algorithm>

namespace pentimento {

namespace {
/// Calls body(the cells in a tile's plane, its first one nullptr if there is none; place along the
/// range; cells along the range) for the tiles of a range.
template <typename Body>
void for_pieces(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, const LineRange& range,
                const Body& body) {
  const int side = canvas.layout().side();
  int done = 0;
  while (done < range.cells) {
    const int at = range.begin + done;
    const int within = at % side;
    const int cells = std::min(side - within, range.cells - done);
    DetailTile* tile = canvas.find(run.tiles[static_cast<std::size_t>(at / side)]);
    float* data = tile == nullptr ? nullptr : q.of(*tile).data();
    const bool along_x = run.axis == Axis::kX;
    const int row = along_x ? range.line : within, column = along_x ? within : range.line;
    if (data != nullptr) data += static_cast<std::ptrdiff_t>(row) * side + column;
    body(FloatBlock<float>{data, side}, done, cells);
    done += cells;
  }
}
}  // namespace

std::vector<TileRun> runs_of(const DetailLayout& layout, const ChangedBlocks& blocks, Axis axis) {
  const bool along_x = axis == Axis::kX;
  const int lines = along_x ? layout.rows() : layout.columns();
  const int length = along_x ? layout.columns() : layout.rows();
  std::vector<TileRun> runs;
  for (int line = 0; line < lines; ++line) {
    bool open = false;
    for (int i = 0; i < length; ++i) {
      const int tile = along_x ? layout.tile_of(i, line) : layout.tile_of(line, i);
      if (!blocks.has(tile)) {
        open = false;
        continue;
      }
      const CellBox box = layout.box(tile);
      if (!open) runs.push_back({axis, {}, box});
      open = true;
      TileRun& run = runs.back();
      run.tiles.push_back(tile);
      run.box.x1 = std::max(run.box.x1, box.x1);
      run.box.y1 = std::max(run.box.y1, box.y1);
    }
  }
  return runs;
}

void load_lines(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, const LineRange& range,
                const FloatBlock<float>& out) {
  for_pieces(canvas, run, q, range, [&](const FloatBlock<float>& cells, int at, int n) {
    if (cells.first != nullptr && run.axis == Axis::kY) {
      transpose({cells.first, cells.stride}, n, range.lines, {out.first + at, out.stride});
      return;
    }
    for (int l = 0; l < range.lines; ++l) {
      float* to = out.first + l * out.stride + at;
      if (cells.first == nullptr) {
        std::fill_n(to, n, 0.0f);
      } else {
        std::copy_n(cells.first + l * cells.stride, n, to);
      }
    }
  });
}

void store_lines(DetailCanvas& canvas, const TileRun& run, const WetPlane& q,
                 const LineRange& range, const FloatBlock<const float>& in) {
  for_pieces(canvas, run, q, range, [&](const FloatBlock<float>& cells, int at, int n) {
    if (cells.first == nullptr) return;
    if (run.axis == Axis::kY) {
      transpose({in.first + at, in.stride}, range.lines, n, cells);
      return;
    }
    for (int l = 0; l < range.lines; ++l)
      std::copy_n(in.first + l * in.stride + at, n, cells.first + l * cells.stride);
  });
}

bool has_plane(DetailCanvas& canvas, const TileRun& run, const WetPlane& q) {
  return std::any_of(run.tiles.begin(), run.tiles.end(), [&](int tile) {
    DetailTile* made = canvas.find(tile);
    return made != nullptr && static_cast<bool>(q.of(*made));
  });
}

}  // namespace pentimento

#include "core/detail/store/tile_line.h"

#include <algorithm>

namespace pentimento {

namespace {
/// Calls body(plane or nullptr, first element, stride, where in the line's part, cells).
template <typename Body>
void for_pieces(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, int line, int begin,
                int count, const Body& body) {
  const int side = canvas.layout().side();
  int done = 0;
  while (done < count) {
    const int at = begin + done;
    const int within = at % side;
    const int cells = std::min(side - within, count - done);
    DetailTile* tile = canvas.find(run.tiles[static_cast<std::size_t>(at / side)]);
    float* data = tile == nullptr ? nullptr : q.of(*tile).data();
    const bool along_x = run.axis == Axis::kX;
    const std::ptrdiff_t first = along_x ? static_cast<std::ptrdiff_t>(line) * side + within
                                         : static_cast<std::ptrdiff_t>(within) * side + line;
    body(data, first, along_x ? 1 : side, done, cells);
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

void load_line(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, int line, int begin,
               std::span<float> out) {
  for_pieces(canvas, run, q, line, begin, static_cast<int>(out.size()),
             [&](const float* data, std::ptrdiff_t first, std::ptrdiff_t stride, int at, int n) {
               float* to = out.data() + at;
               if (data == nullptr) {
                 std::fill_n(to, n, 0.0f);
               } else if (stride == 1) {
                 std::copy_n(data + first, n, to);
               } else {
                 for (int i = 0; i < n; ++i) to[i] = data[first + i * stride];
               }
             });
}

void store_line(DetailCanvas& canvas, const TileRun& run, const WetPlane& q, int line, int begin,
                std::span<const float> in) {
  for_pieces(canvas, run, q, line, begin, static_cast<int>(in.size()),
             [&](float* data, std::ptrdiff_t first, std::ptrdiff_t stride, int at, int n) {
               const float* from = in.data() + at;
               if (data == nullptr) return;
               if (stride == 1) {
                 std::copy_n(from, n, data + first);
               } else {
                 for (int i = 0; i < n; ++i) data[first + i * stride] = from[i];
               }
             });
}

bool has_plane(DetailCanvas& canvas, const TileRun& run, const WetPlane& q) {
  return std::any_of(run.tiles.begin(), run.tiles.end(), [&](int tile) {
    DetailTile* made = canvas.find(tile);
    return made != nullptr && static_cast<bool>(q.of(*made));
  });
}

}  // namespace pentimento

#include "core/fluid/paper/live_rows.h"

#include <array>
#include <bit>

namespace pentimento::paper {

namespace {

constexpr int kBlock = 64;  // cells looked at together: four cache lines of each plane

using RowPlanes = std::array<const float*, 3>;

bool any_nonzero(const RowPlanes& rows, int begin, int end) {
  std::uint32_t bits = 0;
  for (int x = begin; x < end; ++x)
    bits |= std::bit_cast<std::uint32_t>(rows[0][x]) | std::bit_cast<std::uint32_t>(rows[1][x]) |
            std::bit_cast<std::uint32_t>(rows[2][x]);
  return bits != 0;
}

/// The blocks between the first and the last that hold anything.
Columns nonzero_blocks(const RowPlanes& rows, int width) {
  int begin = 0;
  while (begin < width && !any_nonzero(rows, begin, std::min(begin + kBlock, width)))
    begin += kBlock;
  if (begin >= width) return {};
  int last = (width - 1) / kBlock * kBlock;
  while (last > begin && !any_nonzero(rows, last, std::min(last + kBlock, width))) last -= kBlock;
  return {begin, std::min(last + kBlock, width)};
}

/// The cells between the first and the last that hold anything.
Columns nonzero_cells(const RowPlanes& rows, int width) {
  Columns c = nonzero_blocks(rows, width);
  while (!c.empty() && !any_nonzero(rows, c.begin, c.begin + 1)) ++c.begin;
  while (!c.empty() && !any_nonzero(rows, c.end - 1, c.end)) --c.end;
  return c;
}

Columns with_neighbours(const std::vector<Columns>& rows, int y, int width) {
  const auto i = static_cast<std::size_t>(y);
  Columns c = rows[i];
  if (y > 0) c = hull(c, rows[i - 1]);
  if (i + 1 < rows.size()) c = hull(c, rows[i + 1]);
  return widened(c, width);
}

}  // namespace

void LiveRows::find(const CanvasState& state, const BrushContact& contact, const Threads& threads) {
  const int width = state.geometry.width, height = state.geometry.height;
  for (auto* rows : {&wet_, &live_, &margin_}) rows->assign(static_cast<std::size_t>(height), {});
  threads.for_rows(height, [&](int y) {
    Columns c = nonzero_cells(
        {state.depth_m.row(y), state.velocity_x_m_s.row(y), state.velocity_y_m_s.row(y)}, width);
    if (y >= contact.row_begin && y < contact.row_end) {
      const float* weight = contact.weight.row(y);
      c = hull(c, nonzero_cells({weight, weight, weight}, width));
    }
    wet_[static_cast<std::size_t>(y)] = c;
  });
  row_begin_ = height;
  row_end_ = 0;
  for (int y = 0; y < height; ++y)
    live_[static_cast<std::size_t>(y)] = with_neighbours(wet_, y, width);
  for (int y = 0; y < height; ++y) {
    margin_[static_cast<std::size_t>(y)] = with_neighbours(live_, y, width);
    if (margin(y).empty()) continue;
    row_begin_ = std::min(row_begin_, y);
    row_end_ = y + 1;
  }
}

std::int64_t LiveRows::cells() const {
  std::int64_t sum = 0;
  for (const Columns& c : live_) sum += static_cast<std::int64_t>(c.count());
  return sum;
}

Columns LiveRows::box() const {
  Columns box;
  for (const Columns& c : live_) box = hull(box, c);
  return box;
}

}  // namespace pentimento::paper

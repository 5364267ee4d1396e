#include "core/fluid/paper/sweeps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace pentimento::paper {
namespace {

using Buffers = std::array<std::vector<std::uint64_t>, 2>;

/// A row's new number, which tells from which numbers it was made.
std::uint64_t made_from(const std::vector<std::uint64_t>& rows, int y) {
  const auto at = [&](int row) {
    return rows[static_cast<std::size_t>(std::clamp(row, 0, static_cast<int>(rows.size()) - 1))];
  };
  return at(y - 1) * 3 + at(y) * 5 + at(y + 1) * 7 + 1;
}

Buffers numbered(int rows) {
  Buffers buffers;
  for (auto& buffer : buffers) buffer.assign(static_cast<std::size_t>(rows), 0);
  for (std::size_t y = 0; y < buffers[0].size(); ++y) buffers[0][y] = y * y + 1;
  return buffers;
}

void sweep_row(Buffers& buffers, int sweep, int y) {
  const auto from = static_cast<std::size_t>(sweep % 2);
  buffers[1 - from][static_cast<std::size_t>(y)] = made_from(buffers[from], y);
}

// The oracle: one whole sweep after the other.
TEST(Sweeps, AreAsIfEachWereDoneAsAWhole) {
  for (const int threads : {1, 2, 7})
    for (const int rows : {1, 2, 63, 64, 65, 127, 128, 129, 300})
      for (const int sweeps : {0, 1, 2, 3, 4, 5, 40, 90}) {
        Buffers expected = numbered(rows), found = numbered(rows);
        for (int sweep = 0; sweep < sweeps; ++sweep)
          for (int y = 0; y < rows; ++y) sweep_row(expected, sweep, y);
        for_sweeps(Threads(threads), 0, rows, sweeps,
                   [&](int sweep, int y) { sweep_row(found, sweep, y); });
        const auto last = static_cast<std::size_t>(sweeps % 2);
        EXPECT_EQ(found[last], expected[last])
            << rows << " rows, " << sweeps << " sweeps, " << threads << " threads";
      }
}

TEST(Sweeps, StayWithinTheirRows) {
  std::vector<int> done(300, 0);
  for_sweeps(Threads(1), 100, 250, 4, [&](int, int y) { ++done[static_cast<std::size_t>(y)]; });
  for (int y = 0; y < 300; ++y)
    EXPECT_EQ(done[static_cast<std::size_t>(y)], y >= 100 && y < 250 ? 4 : 0) << y;
}

}  // namespace
}  // namespace pentimento::paper

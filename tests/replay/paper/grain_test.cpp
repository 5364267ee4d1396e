#include "replay/paper/grain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pentimento {
namespace {

TEST(Grain, HasNoSeamWhereItRepeats) {
  // Two repeats of 256 cells: from the last cell of the first to the first of the second the height
  // changes as it does inside.
  constexpr int kRepeat = 256;
  const RepeatGrid grid{2 * kRepeat, 2 * kRepeat, kRepeat, kRepeat};
  float inside = 0, across = 0;
  std::vector<float> row(2 * kRepeat);
  for (int y = 0; y < kRepeat; y += 5) {
    grain_row(grid, 0, y, row);
    for (int x = 1; x < 2 * kRepeat; ++x) {
      float& most = x == kRepeat ? across : inside;
      const auto i = static_cast<std::size_t>(x);
      most = std::max(most, std::abs(row[i] - row[i - 1]));
    }
  }
  EXPECT_GT(across, 0);
  EXPECT_LE(across, inside);
}

}  // namespace
}  // namespace pentimento

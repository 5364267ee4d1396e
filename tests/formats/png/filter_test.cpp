#include "formats/png/filter.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <vector>

namespace pentimento {
namespace {

using PngBytes = std::vector<std::uint8_t>;

/// The standard's reconstruction, byte by byte (section 9.2).
PngBytes unfiltered(const PngBytes& filtered, const PngBytes& above, int bpp) {
  PngBytes row;
  for (std::size_t i = 0; i + 1 < filtered.size(); ++i) {
    const bool first = i < static_cast<std::size_t>(bpp);
    const int a = first ? 0 : row[i - static_cast<std::size_t>(bpp)];
    const int b = above[i];
    const int c = first ? 0 : above[i - static_cast<std::size_t>(bpp)];
    const int p = a + b - c;
    const int pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
    const int paeth = pa <= pb && pa <= pc ? a : (pb <= pc ? b : c);
    const int guess[] = {0, a, b, (a + b) / 2, paeth};
    row.push_back(static_cast<std::uint8_t>(filtered[i + 1] + guess[filtered[0]]));
  }
  return row;
}

PngBytes filtered(const PngBytes& row, const PngBytes& above, int bpp) {
  PngBytes scratch(4 * row.size()), out(row.size() + 1);
  png::filter_row(row, above, bpp, scratch, out.data());
  return out;
}

TEST(PngFilter, IsUndoneByTheStandardsReconstruction) {
  std::mt19937 random(1);
  for (const int bpp : {3, 6})
    for (int pixels = 1; pixels <= 40; ++pixels) {
      PngBytes above(static_cast<std::size_t>(pixels * bpp)), row(above.size());
      for (std::size_t i = 0; i < row.size(); ++i) {
        above[i] = static_cast<std::uint8_t>(random());
        row[i] = static_cast<std::uint8_t>(above[i] + random() % 5 + (pixels % 3 == 0 ? i : 0));
      }
      ASSERT_EQ(unfiltered(filtered(row, above, bpp), above, bpp), row) << pixels << " x " << bpp;
    }
}

TEST(PngFilter, ChoosesWhatLeavesLeast) {
  const PngBytes zeros(12, 0), ramp = {10, 10, 10, 20, 20, 20, 30, 30, 30, 40, 40, 40};
  EXPECT_EQ(filtered(zeros, ramp, 3)[0], 0);  // already zero
  EXPECT_EQ(filtered(ramp, zeros, 3)[0], 1);  // equal steps to the right
  EXPECT_EQ(filtered(ramp, ramp, 3)[0], 2);   // as above
}

}  // namespace
}  // namespace pentimento

#include "replay/compare/convolve.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace pentimento {
namespace {

TEST(Convolve, IsTheSumOverBothAxesAndEdgesGoOn) {
  const Taps across = {1, 2, 4}, down = {8, 16, 32};
  const int width = 4, height = 3;
  Field<float> in(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) in(x, y) = static_cast<float>(1 + x * x + 5 * y);
  const Field<float> out = convolve(in.view(), across, down, Threads(1));
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0;
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          sum += across[static_cast<std::size_t>(i + 1)] * down[static_cast<std::size_t>(j + 1)] *
                 static_cast<double>(
                     in(std::clamp(x + i, 0, width - 1), std::clamp(y + j, 0, height - 1)));
      EXPECT_EQ(static_cast<double>(out(x, y)), sum) << x << ' ' << y;  // whole numbers
    }
}

}  // namespace
}  // namespace pentimento

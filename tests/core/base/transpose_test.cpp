#include "core/base/transpose.h"

#include <gtest/gtest.h>

#include <vector>

namespace pentimento {
namespace {

TEST(Transpose, RowsBecomeColumnsAndNothingElseIsWritten) {
  // Sides of whole fours and others, long ones along either axis, inside larger blocks.
  constexpr int kStride = 30, kOutStride = 25;
  for (const int rows : {1, 3, 4, 7, 16, 21})
    for (const int columns : {1, 2, 4, 6, 16, 22}) {
      std::vector<float> from(kStride * 24), to(kOutStride * 24, -1.0f);
      for (std::size_t i = 0; i < from.size(); ++i) from[i] = static_cast<float>(i);
      transpose({from.data(), kStride}, rows, columns, {to.data(), kOutStride});
      for (int y = 0; y < 24; ++y)
        for (int x = 0; x < kOutStride; ++x) {
          const float expected =
              y < columns && x < rows ? static_cast<float>(x * kStride + y) : -1.0f;
          EXPECT_EQ(to[static_cast<std::size_t>(y * kOutStride + x)], expected)
              << rows << " x " << columns << ": " << x << ", " << y;
        }
    }
}

}  // namespace
}  // namespace pentimento

#include "core/shading/cell_slopes.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

/// A plane that rises by 3 to the right and falls by 2 down, with a bump; its thickness is a tenth.
float height(int x, int y) {
  const float bump = x == 5 && y == 4 ? 8.0f : 0.0f;
  return 3 * static_cast<float>(x) - 2 * static_cast<float>(y) + bump;
}

TEST(CellSlopes, AreCentralDifferencesInEveryCellOfTheWindow) {
  for (const int border : {1, 3})
    for (const int width : {1, 2, 37}) {
      const CellWindow window{4, 3, width, 11};
      std::vector<float> relief;
      for (int y = -border; y < window.height + border; ++y)
        for (int x = -border; x < window.width + border; ++x) {
          relief.push_back(height(x, y));
          relief.push_back(height(x, y) / 10);
        }
      std::vector<float> out;
      pack_slopes({relief, window, border}, {0.5f, 4}, Threads(2), out);
      ASSERT_EQ(out.size(), 4U * 11U * static_cast<std::size_t>(width));
      for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < width; ++x) {
          const float* cell = &out[4 * static_cast<std::size_t>(y * width + x)];
          EXPECT_EQ(cell[0], height(x, y));
          EXPECT_EQ(cell[1], height(x, y) / 10);
          EXPECT_EQ(cell[2], (height(x + 1, y) - height(x - 1, y)) / 2 * 0.5f) << x << ' ' << y;
          EXPECT_EQ(cell[3], (height(x, y + 1) - height(x, y - 1)) / 2 * 4) << x << ' ' << y;
        }
    }
}

}  // namespace
}  // namespace pentimento

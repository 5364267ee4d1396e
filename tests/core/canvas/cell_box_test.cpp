#include "core/canvas/cell_box.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(CellBox, CountsItsCellsAlongEachAxis) {
  const CellBox box{3, 7, 10, 12};
  EXPECT_EQ(box.width(), 4);
  EXPECT_EQ(box.height(), 2);
  EXPECT_FALSE(box.empty());
}

TEST(CellBox, IsEmptyWithoutCellsAlongEitherAxis) {
  EXPECT_TRUE(CellBox{}.empty());
  EXPECT_TRUE((CellBox{3, 3, 0, 5}).empty());
  EXPECT_TRUE((CellBox{0, 5, 3, 3}).empty());
  EXPECT_TRUE((CellBox{8, 0, 0, 5}).empty());  // as a search that found nothing leaves it
}

}  // namespace
}  // namespace pentimento

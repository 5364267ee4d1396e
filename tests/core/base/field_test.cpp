#include "core/base/field.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(Field, RowsStartAtCacheLinesAndValuesAtZero) {
  for (int width = 1; width <= 40; ++width) {
    Field<float> f(width, 3);
    for (int y = 0; y < 3; ++y) {
      EXPECT_EQ(reinterpret_cast<std::uintptr_t>(f.row(y)) % 64, 0u);
      for (int x = 0; x < width; ++x) EXPECT_EQ(f(x, y), 0.0f);
    }
  }
}

TEST(Field, ClonesAreIndependent) {
  Field<int> a(3, 2, 7);
  Field<int> b = a.clone();
  b(1, 1) = 8;
  EXPECT_EQ(a(1, 1), 7);
  EXPECT_EQ(b(1, 1), 8);
}

TEST(FieldView, WindowsShareTheirPlane) {
  Field<int> a(4, 4);
  FieldView<int> w = a.view().window(1, 2, 2, 2);
  w(0, 0) = 5;
  EXPECT_EQ(a(1, 2), 5);
  EXPECT_EQ(w.width(), 2);
}

}  // namespace
}  // namespace pentimento

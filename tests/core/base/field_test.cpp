#include "core/base/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/core/base/resident_memory.h"

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

TEST(Field, ClonesHaveEveryValueOfEveryPage) {
  // 100 columns are 112 values with their padding: pages begin and end within rows.
  Field<float> a(100, 300);
  const std::vector<std::pair<int, int>> at = {{0, 0}, {63, 9}, {64, 9}, {99, 150}, {99, 299}};
  for (std::size_t i = 0; i < at.size(); ++i)
    a(at[i].first, at[i].second) = static_cast<float>(i + 1);
  a(50, 200) = -0.0f;  // a zero whose bits are not: kept
  const Field<float> b = a.clone();
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 100; ++x) ASSERT_EQ(b(x, y), a(x, y)) << x << ", " << y;
  EXPECT_TRUE(std::signbit(b(50, 200)));
}

TEST(Field, StartsAtAValueOtherThanZero) {
  const Field<float> a(100, 300, -0.0f);
  const Field<std::uint8_t> b(100, 300, 3);
  for (int y = 0; y < 300; ++y)
    for (int x = 0; x < 100; ++x) {
      ASSERT_TRUE(std::signbit(a(x, y)));
      ASSERT_EQ(b(x, y), 3);
    }
}

TEST(Field, TakesMemoryOnlyWhereItWasWrittenTo) {
  if (is_marked_when_given()) GTEST_SKIP();
  constexpr int kSide = 8192;  // A plane of 256 MiB.
  const long before_mib = resident_mib();
  Field<float> a(kSide, kSide);
  a(kSide / 2, kSide / 2) = 1.0f;
  // A sanitizer's shadow of the two planes takes an eighth: 64 MiB.
  EXPECT_LT(resident_mib() - before_mib, 80);
  const Field<float> b = a.clone();
  EXPECT_EQ(b(kSide / 2, kSide / 2), 1.0f);
  // Pages that are only read, those of the first plane, are the system's one page of zeros, if it
  // has one.
  EXPECT_LT(resident_mib() - before_mib, 80 + taken_by_reading_mib(256));
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

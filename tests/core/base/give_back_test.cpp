#include "core/base/give_back.h"

#include <gtest/gtest.h>

#include "core/base/field.h"
#include "tests/core/base/resident_memory.h"

namespace pentimento {
namespace {

TEST(GiveBack, MakesZerosOfWholePagesAndNothingElse) {
  constexpr int kWidth = 4096, kHeight = 4096;  // 64 MiB
  Field<float> plane(kWidth, kHeight, 1.0f);
  const long before_mib = resident_mib();
  // All but 100 values at each end of the plane, which lie on pages of their own or of its
  // neighbours.
  constexpr std::size_t kAll = std::size_t{kWidth} * kHeight - 200;
  give_back(plane.row(0) + 100, kAll * sizeof(float));
  const long most_mib = is_marked_when_given() ? 0 : -60;
  EXPECT_LE(resident_mib() - before_mib, most_mib);
  int ones = 0;
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const bool is_one = plane(x, y) == 1.0f;
      ASSERT_TRUE(is_one || plane(x, y) == 0.0f);
      ones += is_one ? 1 : 0;
    }
  EXPECT_GE(ones, 200);
  EXPECT_LE(ones, 200 + 2 * 1024);
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(plane(i, 0), 1.0f);
    EXPECT_EQ(plane(kWidth - 1 - i, kHeight - 1), 1.0f);
  }
  // It is there to be written to.
  plane(2000, 2000) = 2;
  EXPECT_EQ(plane(2000, 2000), 2.0f);
  // Less than a page stays.
  Field<float> small(8, 8, 1.0f);
  give_back(small.row(0), 8 * 16 * sizeof(float));
  EXPECT_EQ(small(3, 3), 1.0f);
}

}  // namespace
}  // namespace pentimento

#include "core/base/finite.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace pentimento {
namespace {

TEST(AllFinite, FindsEachKindOfNonFiniteValueAnywhere) {
  for (std::size_t width = 1; width <= 40; ++width)
    for (std::size_t at = 0; at < width; ++at)
      for (const float bad :
           {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
            std::numeric_limits<float>::quiet_NaN()}) {
        std::vector<float> row(width, std::numeric_limits<float>::max());
        EXPECT_TRUE(all_finite(row));
        row[at] = bad;
        EXPECT_FALSE(all_finite(row));
      }
}

TEST(AllFinite, PassesSubnormalsAndZeros) {
  const std::vector<float> row = {0.0f, -0.0f, std::numeric_limits<float>::denorm_min(),
                                  std::numeric_limits<float>::lowest()};
  EXPECT_TRUE(all_finite(row));
}

}  // namespace
}  // namespace pentimento

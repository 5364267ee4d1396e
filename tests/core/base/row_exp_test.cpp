#include "core/base/row_exp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pentimento {
namespace {

TEST(RowExp, IsTheExponentialOfWhatIsNotPositive) {
  for (int i = 0; i < 87000; ++i) {
    const float x = -0.001f * static_cast<float>(i);
    const double truth = std::exp(static_cast<double>(x));
    // The reduced argument is rounded to 24 bits, as is the result.
    ASSERT_NEAR(static_cast<double>(row_exp(x)) / truth, 1, 3e-7) << x;
  }
  EXPECT_EQ(row_exp(0), 1);
  EXPECT_EQ(row_exp(-1e30f), row_exp(-87));
  EXPECT_GT(row_exp(-87), 0);
}

}  // namespace
}  // namespace pentimento

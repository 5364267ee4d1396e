#include "core/base/any_not_zero.h"

#include <gtest/gtest.h>

#include <vector>

namespace pentimento {
namespace {

TEST(AnyNotZero, FindsOneValueWhereverItIs) {
  std::vector<float> values(37, 0.0f);  // whole vectors of any width, and a rest
  EXPECT_FALSE(any_not_zero(values.data(), 37));
  EXPECT_FALSE(any_not_zero(values.data(), 0));
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = 1e-45f;  // the least there is
    EXPECT_TRUE(any_not_zero(values.data(), 37)) << i;
    EXPECT_FALSE(any_not_zero(values.data(), static_cast<int>(i)));
    values[i] = -0.0f;  // no paint either
    EXPECT_FALSE(any_not_zero(values.data(), 37)) << i;
    values[i] = 0;
  }
}

}  // namespace
}  // namespace pentimento

#include "core/base/float_environment.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

/// 1 and a third of its last bit: what becomes of it tells how sums are rounded.
double sum_of_parts() {
  volatile double one = 1, little = 1e-17;
  return one + little;
}

TEST(PlainArithmetic, RoundsToNearest_ThenTheCallerHasItsOwnAgain) {
  std::fenv_t before;
  std::fegetenv(&before);
  std::fesetround(FE_UPWARD);
  EXPECT_GT(sum_of_parts(), 1.0);
  {
    const PlainArithmetic plain;
    EXPECT_EQ(sum_of_parts(), 1.0);
  }
  EXPECT_GT(sum_of_parts(), 1.0);
  std::fesetenv(&before);
}

TEST(PlainArithmetic, KeepsDenormalNumbers) {
  const PlainArithmetic plain;
  volatile float tiny = 1e-38f;
  EXPECT_GT(tiny * 0.1f, 0.0f);
}

}  // namespace
}  // namespace pentimento

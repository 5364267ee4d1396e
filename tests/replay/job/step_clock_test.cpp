#include "replay/job/step_clock.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

TEST(StepClock, AStepHoldsItsBeginningButNotItsEnd) {
  const StepClock clock(50);  // dt = 20 000 us
  EXPECT_EQ(clock.step_of(0), 0);
  EXPECT_EQ(clock.step_of(19'999), 0);
  EXPECT_EQ(clock.step_of(20'000), 1);
  EXPECT_EQ(clock.step_of(1'000'000), 50);
}

TEST(StepClock, StepsOfAFortyFifthNeverDrift) {
  // 1/45 s is no whole number of microseconds: after a day the step must still be exact.
  const StepClock clock(45);
  constexpr std::int64_t kDay_us = 86'400'000'000;
  EXPECT_EQ(clock.step_of(kDay_us), 86'400 * 45);
  EXPECT_EQ(clock.step_of(kDay_us - 1), 86'400 * 45 - 1);
}

TEST(StepClock, AFractionalRateIsTheDecimalNumberWritten) {
  // 29.97 in binary is a little less; 100 s are exactly 2997 steps all the same.
  const StepClock clock(29.97);
  EXPECT_EQ(clock.step_of(100'000'000), 2997);
  EXPECT_EQ(clock.step_of(99'999'999), 2996);
  EXPECT_DOUBLE_EQ(clock.seconds(2997), 100.0);
}

TEST(StepClock, RatesWithExponentsAreRead) {
  EXPECT_EQ(StepClock(1e4).step_of(1'000'000), 10'000);
  EXPECT_EQ(StepClock(12.5).step_of(80'000), 1);
  EXPECT_EQ(StepClock(1e-5).step_of(99'999'999'999), 0);
  EXPECT_EQ(StepClock(1e-5).step_of(100'000'000'000), 1);
}

TEST(StepClock, StepsInRoundsUp) {
  const StepClock clock(45);
  EXPECT_EQ(clock.steps_in(0), 0);
  EXPECT_EQ(clock.steps_in(1), 1);
  EXPECT_EQ(clock.steps_in(1'000'000), 45);
}

TEST(StepClock, ARateOfAllDigitsDoesNotOverflow) {
  const StepClock clock(59.940059940059939);
  // 10^9 s, more than a log may last; the quotient in exact arithmetic is 59940059940.06.
  EXPECT_EQ(clock.step_of(1'000'000'000'000'000), 59'940'059'940);
}

}  // namespace
}  // namespace pentimento

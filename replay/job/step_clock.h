#pragma once
// Finds the simulation step in which a moment of the log falls. It is exact: `steps_per_second` is
// the decimal number that the log writes (29.97 is 2997/100), and all other numbers are whole.

#include <cstdint>

namespace pentimento {

class StepClock {
 public:
  /// `steps_per_second`: finite, > 0. Its shortest decimal form counts.
  explicit StepClock(double steps_per_second);

  /// The step [n dt, (n+1) dt) that `time_us` >= 0 falls in.
  std::int64_t step_of(std::int64_t time_us) const;
  /// The fewest steps that last at least `time_us` >= 0.
  std::int64_t steps_in(std::int64_t time_us) const;
  /// Simulated time of `steps` steps, s.
  double seconds(std::int64_t steps) const;
  /// Duration of a step, s.
  float dt_s() const;

 private:
  std::int64_t numerator_ = 1;  // steps_per_second = numerator / denominator
  std::int64_t denominator_ = 1;
};

}  // namespace pentimento

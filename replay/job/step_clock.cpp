#include "replay/job/step_clock.h"

#include <charconv>
#include <string_view>

#include "core/base/check.h"

namespace pentimento {

namespace {
__extension__ using Wide = __int128;
constexpr std::int64_t kMicroseconds = 1'000'000;

/// The decimal number in `text` ("29.97", "1e-05") as digits x 10^exponent.
struct Decimal {
  std::int64_t digits = 0;
  int exponent = 0;
};

Decimal parse_decimal(std::string_view text) {
  Decimal d;
  bool fraction = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '.') {
      fraction = true;
    } else if (c == 'e') {
      const std::size_t start = text[i + 1] == '+' ? i + 2 : i + 1;
      int exponent = 0;
      std::from_chars(text.data() + start, text.data() + text.size(), exponent);
      d.exponent += exponent;
      break;
    } else {
      d.digits = d.digits * 10 + (c - '0');
      if (fraction) --d.exponent;
    }
  }
  return d;
}
}  // namespace

StepClock::StepClock(double steps_per_second) {
  PENTIMENTO_CHECK(steps_per_second >= 1e-6 && steps_per_second <= 1e9);
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, steps_per_second);
  Decimal d = parse_decimal({text, static_cast<std::size_t>(end.ptr - text)});
  while (d.exponent < 0 && d.digits % 10 == 0) {
    d.digits /= 10;
    ++d.exponent;
  }
  // A double has at most 17 digits: beyond 10^18 the rest could not be told apart anyway.
  for (; d.exponent < -18; ++d.exponent) d.digits /= 10;
  numerator_ = d.digits;
  for (; d.exponent > 0; --d.exponent) numerator_ *= 10;
  for (; d.exponent < 0; ++d.exponent) denominator_ *= 10;
}

std::int64_t StepClock::step_of(std::int64_t time_us) const {
  PENTIMENTO_CHECK(time_us >= 0);
  return static_cast<std::int64_t>(Wide{time_us} * numerator_ /
                                   (Wide{denominator_} * kMicroseconds));
}

std::int64_t StepClock::steps_in(std::int64_t time_us) const {
  PENTIMENTO_CHECK(time_us >= 0);
  const Wide unit = Wide{denominator_} * kMicroseconds;
  return static_cast<std::int64_t>((Wide{time_us} * numerator_ + unit - 1) / unit);
}

double StepClock::seconds(std::int64_t steps) const {
  return static_cast<double>(steps) * static_cast<double>(denominator_) /
         static_cast<double>(numerator_);
}

float StepClock::dt_s() const {
  return static_cast<float>(seconds(1));
}

}  // namespace pentimento

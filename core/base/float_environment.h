#pragma once
// The floating-point environment of a thread: how results are rounded, and whether denormal numbers
// count as zero. The state is a function of the log alone (ADR 2), so no arithmetic of ours may run
// in an environment that somebody else has left.

#include <cfenv>

namespace pentimento {

/// Rounds to nearest, keeps denormal numbers, raises no signals; from here on, in this thread.
inline void set_plain_arithmetic() {
  std::fesetenv(FE_DFL_ENV);
}

/// Plain arithmetic for as long as it lives, in the thread that makes it. Then the caller has its
/// own environment back: who calls the library may have another.
class PlainArithmetic {
 public:
  PlainArithmetic() {
    std::fegetenv(&before_);
    set_plain_arithmetic();
  }
  ~PlainArithmetic() { std::fesetenv(&before_); }
  PlainArithmetic(const PlainArithmetic&) = delete;
  PlainArithmetic& operator=(const PlainArithmetic&) = delete;

 private:
  std::fenv_t before_;
};

}  // namespace pentimento

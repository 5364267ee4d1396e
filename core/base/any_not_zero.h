#pragma once
// A look through a row for anything but zeros.

namespace pentimento {

/// The same as any_not_zero(), value by value.
bool search_not_zero(const float* values, int n);

/// Whether any of the `n` values is not zero. What lies somewhere mostly lies in the middle, too.
inline bool any_not_zero(const float* values, int n) {
  return n > 0 && (values[n / 2] != 0 || search_not_zero(values, n));
}

}  // namespace pentimento

#pragma once
// A look through a row for anything but zeros.

namespace pentimento {

/// Whether any of the `n` values is not zero.
bool any_not_zero(const float* values, int n);

}  // namespace pentimento

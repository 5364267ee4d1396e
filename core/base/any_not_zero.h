#pragma once
// Whether a row has anything in it.

namespace pentimento {

/// Whether any of the `n` values is not zero.
bool any_not_zero(const float* values, int n);

}  // namespace pentimento

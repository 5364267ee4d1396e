#pragma once
// Copies a block of values with its rows as columns.

#include <cstddef>

namespace pentimento {

/// Rows and columns of floats. Row r, column c lies at first[r * stride + c].
template <typename Float>
struct FloatBlock {
  Float* first = nullptr;
  std::ptrdiff_t stride = 0;
};

/// to(c, r) = from(r, c), for `rows` rows and `columns` columns of `from`. The blocks must not
/// overlap.
void transpose(const FloatBlock<const float>& from, int rows, int columns,
               const FloatBlock<float>& to);

}  // namespace pentimento

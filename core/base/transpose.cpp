#include "core/base/transpose.h"

#include <algorithm>

#include "core/base/four.h"

namespace pentimento {

namespace {
constexpr int kSide = 4;

/// Four rows of four.
inline void transpose_fours(const float* from, std::ptrdiff_t from_stride, float* to,
                            std::ptrdiff_t to_stride) {
  const Four a = four_at(from), b = four_at(from + from_stride);
  const Four c = four_at(from + 2 * from_stride), d = four_at(from + 3 * from_stride);
  // Pairs of rows are mixed value by value, then pairs of those two by two.
  const Four ab_low = __builtin_shufflevector(a, b, 0, 4, 1, 5);
  const Four ab_high = __builtin_shufflevector(a, b, 2, 6, 3, 7);
  const Four cd_low = __builtin_shufflevector(c, d, 0, 4, 1, 5);
  const Four cd_high = __builtin_shufflevector(c, d, 2, 6, 3, 7);
  put_four(__builtin_shufflevector(ab_low, cd_low, 0, 1, 4, 5), to);
  put_four(__builtin_shufflevector(ab_low, cd_low, 2, 3, 6, 7), to + to_stride);
  put_four(__builtin_shufflevector(ab_high, cd_high, 0, 1, 4, 5), to + 2 * to_stride);
  put_four(__builtin_shufflevector(ab_high, cd_high, 2, 3, 6, 7), to + 3 * to_stride);
}
}  // namespace

void transpose(const FloatBlock<const float>& from, int rows, int columns,
               const FloatBlock<float>& to) {
  const auto piece = [&](int r, int c) {
    const float* first = from.first + r * from.stride + c;
    float* out = to.first + c * to.stride + r;
    if (r + kSide <= rows && c + kSide <= columns) {
      transpose_fours(first, from.stride, out, to.stride);
      return;
    }
    for (int y = 0; y < std::min(kSide, rows - r); ++y)
      for (int x = 0; x < std::min(kSide, columns - c); ++x)
        out[x * to.stride + y] = first[y * from.stride + x];
  };
  // Along the longer side, so that a line of the cache is used up before the next one.
  if (rows > columns) {
    for (int r = 0; r < rows; r += kSide)
      for (int c = 0; c < columns; c += kSide) piece(r, c);
  } else {
    for (int c = 0; c < columns; c += kSide)
      for (int r = 0; r < rows; r += kSide) piece(r, c);
  }
}

}  // namespace pentimento

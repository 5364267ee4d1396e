#pragma once
// Asks for memory that a pass over rows comes to soon. Rows of a canvas lie in pages of their own,
// and the processor does not foresee the next row of a short run: the pass would wait for it.
// Changes no value.

#include <cstddef>

namespace pentimento {

/// How far ahead of a pass: as many rows as take it as long as memory takes to answer.
inline constexpr int kRowsAhead = 2;

/// Asks for the values row[0] .. row[n - 1], which must exist.
template <typename T>
void fetch_ahead(const T* row, int n) {
#if defined(__GNUC__)
  constexpr int kPerLine = 64 / static_cast<int>(sizeof(T));  // in a line of the cache
  for (int i = 0; i < n; i += kPerLine) __builtin_prefetch(row + i);
#else
  static_cast<void>(row);
  static_cast<void>(n);
#endif
}

}  // namespace pentimento

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

/// Asks for the cells [x0, x1) of the row of `plane`, anything with row(y) and height(), that lies
/// kRowsAhead rows below row y. Rows that are written next are worth asking for, too: the processor
/// fetches a line before it writes to it, and does not go on reading there meanwhile.
template <typename Plane>
void fetch_row_ahead(const Plane& plane, int y, int x0, int x1) {
  if (y + kRowsAhead < plane.height()) fetch_ahead(plane.row(y + kRowsAhead) + x0, x1 - x0);
}

}  // namespace pentimento

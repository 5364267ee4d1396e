#pragma once

#include <cstddef>

namespace pentimento {

/// The cells [begin, end) of a row of a stamp's box that the tip touches.
struct TouchedCells {
  int begin = 0, end = 0;
  std::size_t at = 0;  // of the first of them among the touched cells of all rows

  std::size_t count() const { return static_cast<std::size_t>(end - begin); }
};

}  // namespace pentimento

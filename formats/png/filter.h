#pragma once
// The five row filters of PNG (ISO/IEC 15948, section 9) and the choice among them.

#include <cstdint>
#include <span>

namespace pentimento::png {

/// Writes filter type and filtered row to `out` (1 + row.size() bytes): the filter with the
/// smallest sum of absolute differences (bytes taken as signed), the heuristic the standard
/// recommends; the first of equals. `above` is the row before (zeros for the first row), `bpp` the
/// bytes of a pixel. `scratch`: 4 rows.
void filter_row(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above, int bpp,
                std::span<std::uint8_t> scratch, std::uint8_t* out);

}  // namespace pentimento::png

#pragma once
// The five row filters of PNG (ISO/IEC 15948, section 9) and the choice among them.

#include <cstdint>
#include <span>

namespace pentimento::png {

/// Writes the filter type and the filtered row to `out`, 1 + row.size() bytes. It takes the filter
/// with the smallest sum of absolute values (bytes taken as signed), the first of equals, as the
/// standard recommends. `above`: the row before, zeros for the first row. `bpp`: bytes of a pixel.
/// `scratch`: memory for 4 rows.
void filter_row(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above, int bpp,
                std::span<std::uint8_t> scratch, std::uint8_t* out);

}  // namespace pentimento::png

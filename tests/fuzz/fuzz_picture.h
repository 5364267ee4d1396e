#pragma once
// Pictures and palettes that a log or an option names.

#include <string_view>

namespace pentimento::test {

/// Reads the bytes in every way in which pictures are read, and their description.
void fuzz_picture(std::string_view bytes);
/// Reads a palette file and makes its paints, in red, green and blue and in bands.
void fuzz_palette(std::string_view bytes);

}  // namespace pentimento::test

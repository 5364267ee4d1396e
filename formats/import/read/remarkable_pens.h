#pragma once
// What the pens and colours of reMarkable's files are in a log. Pure functions.

#include "formats/import/sketch/byte_reader.h"
#include "formats/import/sketch/sketch.h"

namespace pentimento::sketch {

/// Sets brush, eraser and opacity of a stroke by the number of its pen.
void set_pen(std::uint32_t pen, Stroke& stroke);

/// Sets the colour by its number; `argb` is that of number 9.
void set_pen_color(std::uint32_t color, std::uint32_t argb, Stroke& stroke);

/// A point of versions 3 and 5, and of line blocks of version 1: 24 bytes. Widens the stroke.
inline constexpr std::size_t kLongPointBytes = 24;
void read_long_point(ByteReader& in, Stroke& stroke);

/// A point of line blocks of version 2: 14 bytes. Widens the stroke.
inline constexpr std::size_t kShortPointBytes = 14;
void read_short_point(ByteReader& in, Stroke& stroke);

}  // namespace pentimento::sketch

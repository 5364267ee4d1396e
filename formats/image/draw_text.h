#pragma once
// Lines of text in pictures, for legends. Through the module of pictures, loaded at first use.

#include <cstdint>
#include <string>

#include "core/base/field.h"
#include "core/base/result.h"

namespace pentimento {

struct TextStyle {
  double scale = 0.5;  // 1: capitals are 21 pixels high
  int thickness = 1;   // of its lines, pixels
};

/// Of a line of ASCII text, pixels. Errors: kIo, the module cannot be loaded.
Result<int> text_width(const std::string& text, const TextStyle& style);

/// Draws with the base line's left end at (x, y) into `mask`: 0 to 255, how much of a pixel is
/// covered. What falls outside is cut. Errors: kIo.
Result<void> draw_text(const std::string& text, const TextStyle& style, int x, int y,
                       Field<std::uint8_t>& mask);

}  // namespace pentimento

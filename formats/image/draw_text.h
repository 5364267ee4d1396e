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

/// Width of a line of ASCII text in pixels. Errors: kIo, the module cannot be loaded.
Result<int> text_width(const std::string& text, const TextStyle& style);

/// Draws a line into `mask`, with the left end of its base line at (x, y). A value of `mask`, 0 to
/// 255, says how much of a pixel is covered. Parts outside are cut off. Errors: kIo.
Result<void> draw_text(const std::string& text, const TextStyle& style, int x, int y,
                       Field<std::uint8_t>& mask);

}  // namespace pentimento

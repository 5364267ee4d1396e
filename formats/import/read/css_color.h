#pragma once
// Colours as web formats write them.

#include <optional>
#include <string_view>

#include "formats/log/tables/events.h"

namespace pentimento::sketch {

struct CssColor {
  log::Rgb linear = {0, 0, 0};  // linear light
  double opacity = 1;           // 0..1
};

/// `#rgb`, `#rgba`, `#rrggbb`, `#rrggbbaa` or one of the usual names, in any case; nothing if it is
/// anything else.
std::optional<CssColor> css_color(std::string_view text);

}  // namespace pentimento::sketch

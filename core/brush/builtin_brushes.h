#pragma once
// The brushes that a log may name without defining them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/brush/brush_settings.h"

namespace pentimento {

/// The built-in brush of that name; nothing if there is none.
std::optional<BrushDefinition> builtin_brush(std::string_view name);
/// The names of all built-in brushes, in the order of the documentation.
std::vector<std::string> builtin_brush_names();

}  // namespace pentimento

#pragma once
// The brushes every log may name without defining them.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/brush/brush_settings.h"

namespace pentimento {

/// The built-in brush of that name; nothing if there is none.
std::optional<BrushDefinition> builtin_brush(std::string_view name);
/// All of them, in the order of documentation.
std::vector<std::string> builtin_brush_names();

}  // namespace pentimento

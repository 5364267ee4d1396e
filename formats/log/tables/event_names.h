#pragma once
// How a log spells types and phases.

#include <cstddef>
#include <string_view>

#include "formats/log/tables/events.h"

namespace pentimento::log {

/// "touch", "gravity", ... of the variant's alternative `index`; "x-" for extensions.
std::string_view type_name(std::size_t index);
inline std::string_view type_name(const Action& action) {
  return type_name(action.index());
}
std::string_view phase_name(TouchPhase phase);

}  // namespace pentimento::log

#include "formats/log/tables/event_names.h"

#include <array>

namespace pentimento::log {

std::string_view type_name(std::size_t index) {
  // In the order of the variant.
  static constexpr std::array<std::string_view, std::variant_size_v<Action>> kNames = {
      "touch", "gravity", "slider", "color",       "brush",  "dry",  "clear", "load",
      "undo",  "redo",    "light",  "environment", "camera", "step", "mark",  "x-"};
  return kNames[index];
}

std::string_view phase_name(TouchPhase phase) {
  static constexpr std::array<std::string_view, 4> kNames = {"down", "move", "up", "cancel"};
  return kNames[static_cast<std::size_t>(phase)];
}

}  // namespace pentimento::log

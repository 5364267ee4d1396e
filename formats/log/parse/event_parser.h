#pragma once
// Turns one line of JSON into an event, and checks names, kinds and ranges of its fields. Checks
// that need other lines (order, touches, known names) are in log_rules.h.

#include <string>
#include <string_view>

#include "formats/log/json/json_line.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

/// `text` is the line that `json` was parsed from. Returns what is wrong, or an empty string.
std::string parse_event(const JsonLine& json, std::string_view text, Event& event);

}  // namespace pentimento::log

#pragma once
// Pieces of JSON text, as the writer and the messages use them.

#include <string>
#include <string_view>

namespace pentimento::log {

/// Appends `text` (UTF-8) in quotes, with quotes, backslashes and control characters escaped.
void append_json_string(std::string& json, std::string_view text);

/// Appends the shortest digits that read back as the same double. `value` is finite.
void append_json_number(std::string& json, double value);

}  // namespace pentimento::log

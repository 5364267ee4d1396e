#include "formats/log/json/json_text.h"

#include <fmt/format.h>

#include <iterator>

namespace pentimento::log {

void append_json_string(std::string& json, std::string_view text) {
  json += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      json += '\\';
      json += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      fmt::format_to(std::back_inserter(json), "\\u{:04x}", static_cast<unsigned int>(c));
    } else {
      json += c;
    }
  }
  json += '"';
}

void append_json_number(std::string& json, double value) {
  fmt::format_to(std::back_inserter(json), "{}", value);
}

}  // namespace pentimento::log

#pragma once
// Names as people write them: "Hooker's Green", "hookers-green" and "hookers_green" are one.

#include <string>
#include <string_view>

namespace pentimento {

/// Lower case, '-' and '_' as spaces, without apostrophes.
inline std::string plain_name(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c == '\'') continue;
    if (c == '-' || c == '_') {
      out += ' ';
    } else {
      out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
  }
  return out;
}

}  // namespace pentimento

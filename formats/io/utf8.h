#pragma once
// Text for file headers.

#include <string>
#include <string_view>

namespace pentimento {

/// `text` with each byte that is not part of valid UTF-8 (and each NUL) replaced by U+FFFD.
std::string valid_utf8(std::string_view text);
/// Only printable ASCII and line feeds?
bool is_plain_ascii(std::string_view text);

}  // namespace pentimento

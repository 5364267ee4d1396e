#pragma once
// Text for file headers and for messages.

#include <string>
#include <string_view>

namespace pentimento {

/// `text` with each byte that is not part of valid UTF-8 (and each NUL) replaced by U+FFFD.
std::string valid_utf8(std::string_view text);
/// `text`, which is UTF-8, as one line that a terminal shows and does not obey: control characters
/// (U+0000 to U+001F, U+007F to U+009F) become spaces.
std::string one_line(std::string_view text);
/// `text`, which is UTF-8, as one line of at most `most_bytes` >= 8: control characters become
/// spaces, and of a longer one the beginning is left, "..", and the end, a third.
std::string brief_line(std::string_view text, std::size_t most_bytes);
/// Only printable ASCII and line feeds?
bool is_plain_ascii(std::string_view text);

}  // namespace pentimento

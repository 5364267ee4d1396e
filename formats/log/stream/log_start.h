#pragma once
// Tells logs from other files.

#include <string>

namespace pentimento::log {

/// Whether the file begins as an action log does: compressed, or with a header in its first line.
/// False for what cannot be opened.
bool starts_like_a_log(const std::string& path);

}  // namespace pentimento::log

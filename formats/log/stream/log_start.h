#pragma once
// Tells logs from other files.

#include <string>

#include "formats/log/stream/byte_source.h"

namespace pentimento::log {

/// Whether the file begins as an action log does: with a header in its first line, unpacked if it
/// is compressed. True where the packed bytes are damaged at once: the reader of logs says where.
/// False for what cannot be opened, and for pipes, of which nothing is read.
bool starts_like_a_log(const std::string& path);
/// The same of bytes from their start, which are at their start again then.
Result<bool> starts_like_a_log(ByteSource& source);

}  // namespace pentimento::log

#pragma once
// A whole file in memory, for formats that cannot be read as a stream.

#include <cstdint>
#include <string>

#include "core/base/result.h"

namespace pentimento {

/// The bytes of `path`; "-" is standard input. Errors: kIo, kLimit (more than `most_bytes`).
Result<std::string> read_file(const std::string& path, std::int64_t most_bytes);

}  // namespace pentimento

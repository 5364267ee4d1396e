#pragma once
// The SHA-256 of a file, read piece by piece.

#include <string>

#include "core/base/result.h"

namespace pentimento {

/// 64 lower-case hex digits. Errors: kIo, it cannot be read.
Result<std::string> file_sha256(const std::string& path);

}  // namespace pentimento

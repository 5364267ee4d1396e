#pragma once
// The first bytes of a file that is to be read more than once.

#include <cstddef>
#include <string>

#include "core/base/result.h"

namespace pentimento {

/// At most `count` bytes. A pipe is not waited for. Errors: kIo; kBadInput if it is a pipe, a
/// socket or a device, which cannot be read twice.
Result<std::string> first_bytes(const std::string& path, std::size_t count);

}  // namespace pentimento

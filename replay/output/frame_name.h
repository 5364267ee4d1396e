#pragma once
// The names of numbered frames.

#include <string>

#include "core/base/result.h"

namespace pentimento {

/// `pattern` with the number of the frame in place of its `%d` or `%04d`. Errors: kUsage if the
/// pattern does not have exactly one of these.
Result<std::string> frame_name(const std::string& pattern, int frame);

}  // namespace pentimento

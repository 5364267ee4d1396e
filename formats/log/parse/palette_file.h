#pragma once
// Reads pigments from a file of their own, or from the header of a log.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

/// Reads the member `palette` of a JSON object, which is the whole file or its first line. Errors:
/// kIo; kBadInput with file and reason (no JSON, no palette in it, a pigment that a header could
/// not have); kLimit over 1 MiB.
Result<std::vector<PigmentSpec>> read_palette_file(const std::string& path);

}  // namespace pentimento::log

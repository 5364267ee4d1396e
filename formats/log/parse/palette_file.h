#pragma once
// Pigments out of a file of their own, or out of the header of a log.

#include <string>
#include <vector>

#include "core/base/result.h"
#include "formats/log/tables/events.h"

namespace pentimento::log {

/// The member `palette` of the JSON object that the file is, or that its first line is. Errors:
/// kIo; kBadInput with file and reason: no JSON, no palette in it, a pigment that a header could
/// not have; kLimit over 1 MiB.
Result<std::vector<PigmentSpec>> read_palette_file(const std::string& path);

}  // namespace pentimento::log

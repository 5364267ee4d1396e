#pragma once
// Publishes small files in one call.

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "formats/io/picture_file.h"

namespace pentimento {

/// Writes `bytes` as the file `path`, whole or not at all (output_file.h). Errors: kIo.
Result<Published> publish_bytes(const std::string& path, std::string_view bytes,
                                bool no_clobber = false);

}  // namespace pentimento

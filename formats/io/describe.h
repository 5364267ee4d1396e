#pragma once
// One reader of descriptions per kind of file; describe_file() chooses. Internal to formats.

#include <string>

#include "core/base/result.h"
#include "formats/io/provenance.h"

namespace pentimento {

Result<FileDescription> describe_png(const std::string& path);
Result<FileDescription> describe_exr(const std::string& path);
Result<FileDescription> describe_state(const std::string& path);

}  // namespace pentimento

#pragma once
// How fast the disk of a checkpoint's folder is, before the first slot has told.

#include <string>

#include "core/base/result.h"

namespace pentimento {

/// Writes so many MiB that do not compress into the new file `path`, forces them to the disk and
/// removes the file. Returns the seconds that the writing took, more than 0. Errors: kIo.
Result<double> time_of_writing_s(const std::string& path, int mebibytes);

}  // namespace pentimento

#pragma once
// Reading a dump back before it is published. For this folder only.

#include <string>

#include "core/base/result.h"
#include "formats/hdf5/state_dump.h"

namespace pentimento::hdf5 {

/// Error (kIo, under the name `name`) unless the dump in `file` is whole and has the hashes that it
/// names; kInterrupted once it is cancelled.
Result<void> check_dump_file(const std::string& file, const std::string& name,
                             const DumpReadOptions& options);

}  // namespace pentimento::hdf5

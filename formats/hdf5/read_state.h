#pragma once
// Reading a dump back before it is published. For this folder only.

#include <atomic>
#include <string>

#include "core/base/result.h"

namespace pentimento::hdf5 {

/// Error (kIo, under the name `name`) unless the dump in `file` is whole and has the hashes that it
/// names; kInterrupted once `cancelled`, which may be nullptr, is set.
Result<void> check_dump_file(const std::string& file, const std::string& name,
                             const std::atomic<bool>* cancelled);

}  // namespace pentimento::hdf5

#pragma once
// Reads a dump from an open file, in this process. Damaged bytes can make libhdf5 crash or loop, so
// read_state() does this in a child first. For this folder only.

#include "core/base/result.h"
#include "formats/hdf5/read_canvas.h"
#include "formats/hdf5/state_dump.h"

namespace pentimento::hdf5 {

/// `whole`: the values of the detail canvas too, which are otherwise read when they are needed.
/// `from.path` is the file's name for messages alone. Errors: those of read_state().
Result<StateDump> read_dump(const DumpFile& from, bool whole);

}  // namespace pentimento::hdf5

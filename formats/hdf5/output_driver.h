#pragma once
// Lets HDF5 write straight into an OutputFile, for dumps that do not fit in memory. libhdf5 crashes
// while it closes after a write that failed, so it is not told of failures. The OutputFile keeps
// the first failure, and OutputFile::complete() returns it. For this folder only.

#include <hdf5.h>

#include "formats/hdf5/handle.h"
#include "formats/io/output_file.h"

namespace pentimento::hdf5 {

/// Creates HDF5 files inside `output`, which outlives it and them. One file at a time.
class OutputDriver {
 public:
  explicit OutputDriver(OutputFile& output);
  /// A new HDF5 file, to be closed before the driver. Not ok() if there is no memory.
  Handle create();

 private:
  OutputFile& output_;
  Handle driver_;
};

}  // namespace pentimento::hdf5

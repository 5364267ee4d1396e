#pragma once
// HDF5 writing straight into a file of ours, for dumps that do not fit in memory. libhdf5 does not
// withstand a write that fails (it crashes while it closes), so it is never told: the file keeps
// the first failure, and OutputFile::complete() tells. For this folder only.

#include <hdf5.h>

#include "formats/hdf5/handle.h"
#include "formats/io/output_file.h"

namespace pentimento::hdf5 {

/// Creates HDF5 files inside `output`, which outlives it and them. One file at a time.
class OutputDriver {
 public:
  explicit OutputDriver(OutputFile& output);
  /// A new HDF5 file, to be closed before the driver; not ok() for want of memory.
  Handle create();

 private:
  OutputFile& output_;
  Handle driver_;
};

}  // namespace pentimento::hdf5

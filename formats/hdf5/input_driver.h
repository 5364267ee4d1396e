#pragma once
// Opens HDF5 files that may hold anything. For this folder and its tests only.

#include <hdf5.h>

#include <string>

#include "formats/hdf5/handle.h"

namespace pentimento::hdf5 {

/// Opens a file for reading. A global heap that libhdf5 would walk for ever cannot be read from it:
/// the call that needs it fails. `access` says how the bytes are reached, as for H5Fopen(). Not
/// ok() if the file cannot be opened, or does not have lengths of 8 bytes, as all dumps do.
Handle open_to_read(const std::string& name, hid_t access = H5P_DEFAULT);

}  // namespace pentimento::hdf5

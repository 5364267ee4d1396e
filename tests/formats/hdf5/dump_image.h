#pragma once
// State dumps that lie in memory.

#include <hdf5.h>

#include <string>
#include <string_view>

#include "core/base/check.h"
#include "formats/hdf5/handle.h"
#include "formats/hdf5/state_dump.h"
#include "tests/formats/scratch.h"

namespace pentimento::test {

inline std::string dump_image(const StateDump& dump) {
  const Scratch scratch;
  PENTIMENTO_CHECK(write_state(scratch.path("a.h5"), dump, {}).ok());
  return slurp(scratch.path("a.h5"));
}

/// Access to a file that consists of these bytes.
inline hdf5::Handle access_to_image(std::string_view bytes) {
  constexpr std::size_t kGrowth = std::size_t{1} << 16;
  hdf5::Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_core(access.id(), kGrowth, false);
  std::string copy(bytes);  // the library takes a pointer to what it may change
  H5Pset_file_image(access.id(), copy.data(), copy.size());
  return access;
}

/// Opens such a file. What is changed in it goes away with the handle. Not ok() if it is no HDF5
/// file.
inline hdf5::Handle open_dump_image(std::string_view bytes) {
  return {H5Fopen("image", H5F_ACC_RDWR, access_to_image(bytes).id()), H5Fclose};
}

}  // namespace pentimento::test

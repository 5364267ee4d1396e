// HDF5's functions of these names, for the test programme: they fail as planned, or are the
// library's.

#include "tests/formats/hdf5/faulty_hdf5.h"

#include <dlfcn.h>
#include <hdf5.h>

namespace {
/// The library's function, or a failure: all of them answer with a negative number then.
template <typename Answer, typename... Arguments>
Answer meet(Answer (* /*type*/)(Arguments...), const char* name, Arguments... arguments) {
  if (pentimento::test::FaultyHdf5::fails(name)) return -1;
  const auto next = reinterpret_cast<Answer (*)(Arguments...)>(::dlsym(RTLD_NEXT, name));
  return next(arguments...);
}
}  // namespace

extern "C" {
hid_t H5Dcreate2(hid_t file, const char* name, hid_t type, hid_t space, hid_t links, hid_t creation,
                 hid_t access) {
  return meet(&H5Dcreate2, "H5Dcreate2", file, name, type, space, links, creation, access);
}
herr_t H5Dwrite(hid_t set, hid_t type, hid_t memory, hid_t space, hid_t transfer,
                const void* values) {
  return meet(&H5Dwrite, "H5Dwrite", set, type, memory, space, transfer, values);
}
herr_t H5Dwrite_chunk(hid_t set, hid_t transfer, uint32_t filters, const hsize_t* offset,
                      size_t size, const void* bytes) {
  return meet(&H5Dwrite_chunk, "H5Dwrite_chunk", set, transfer, filters, offset, size, bytes);
}
hid_t H5Acreate2(hid_t object, const char* name, hid_t type, hid_t space, hid_t creation,
                 hid_t access) {
  return meet(&H5Acreate2, "H5Acreate2", object, name, type, space, creation, access);
}
herr_t H5Awrite(hid_t attribute, hid_t type, const void* value) {
  return meet(&H5Awrite, "H5Awrite", attribute, type, value);
}
hid_t H5Gcreate2(hid_t file, const char* name, hid_t links, hid_t creation, hid_t access) {
  return meet(&H5Gcreate2, "H5Gcreate2", file, name, links, creation, access);
}
hid_t H5Gopen2(hid_t file, const char* name, hid_t access) {
  return meet(&H5Gopen2, "H5Gopen2", file, name, access);
}
herr_t H5Dread(hid_t set, hid_t type, hid_t memory, hid_t space, hid_t transfer, void* values) {
  return meet(&H5Dread, "H5Dread", set, type, memory, space, transfer, values);
}
herr_t H5Aread(hid_t attribute, hid_t type, void* value) {
  return meet(&H5Aread, "H5Aread", attribute, type, value);
}
hid_t H5Dget_space(hid_t set) {
  return meet(&H5Dget_space, "H5Dget_space", set);
}
hid_t H5Dget_type(hid_t set) {
  return meet(&H5Dget_type, "H5Dget_type", set);
}
}

#include "formats/hdf5/input_driver.h"

#include <H5FDpublic.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <new>
#include <span>

#include "formats/hdf5/global_heap.h"

namespace pentimento::hdf5 {

namespace {

constexpr std::size_t kLengthBytes = 8;

/// HDF5's own part must come first.
struct GuardedFile {
  H5FD_t base;
  H5FD_t* inner;  // who reads the bytes
};

/// The driver's information in the access list.
struct GuardedInfo {
  hid_t inner_access;
};

H5FD_t* inner_of(const H5FD_t* file) {
  return reinterpret_cast<const GuardedFile*>(file)->inner;
}

H5FD_t* open_guarded(const char* name, unsigned flags, hid_t access, haddr_t last_address) {
  const auto* info = static_cast<const GuardedInfo*>(H5Pget_driver_info(access));
  if (info == nullptr) return nullptr;
  auto* file = new (std::nothrow) GuardedFile{};
  if (file == nullptr) return nullptr;
  file->inner = H5FDopen(name, flags, info->inner_access, last_address);
  if (file->inner != nullptr) return &file->base;
  delete file;
  return nullptr;
}

herr_t close_guarded(H5FD_t* file) {
  const herr_t result = H5FDclose(inner_of(file));
  delete reinterpret_cast<GuardedFile*>(file);
  return result;
}

herr_t query_guarded(const H5FD_t*, unsigned long* flags) {
  if (flags != nullptr) *flags = H5FD_FEAT_ACCUMULATE_METADATA | H5FD_FEAT_DATA_SIEVE;
  return 0;
}

haddr_t guarded_end_of_addresses(const H5FD_t* file, H5FD_mem_t type) {
  return H5FDget_eoa(inner_of(file), type);
}
herr_t set_guarded_end_of_addresses(H5FD_t* file, H5FD_mem_t type, haddr_t address) {
  return H5FDset_eoa(inner_of(file), type, address);
}
haddr_t guarded_end_of_file(const H5FD_t* file, H5FD_mem_t type) {
  return H5FDget_eof(inner_of(file), type);
}

herr_t read_guarded(H5FD_t* file, H5FD_mem_t type, hid_t transfer, haddr_t address,
                    std::size_t size, void* buffer) {
  if (H5FDread(inner_of(file), type, transfer, address, size, buffer) < 0) return -1;
  return is_endless_heap({static_cast<const std::byte*>(buffer), size}) ? -1 : 0;
}

/// The library wants a function for this too.
herr_t refuse_to_write(H5FD_t*, H5FD_mem_t, hid_t, haddr_t, std::size_t, const void*) {
  return -1;
}

H5FD_class_t guarded_class() {
  H5FD_class_t c = {};
#if H5_VERSION_GE(1, 13, 0)
  c.version = H5FD_CLASS_VERSION;
  c.value = static_cast<H5FD_class_value_t>(513);  // from the range that is free for any use
#endif
  c.name = "pentimento-input";
  c.maxaddr = static_cast<haddr_t>(INT64_MAX);
  c.fc_degree = H5F_CLOSE_WEAK;
  c.fapl_size = sizeof(GuardedInfo);
  c.open = open_guarded;
  c.close = close_guarded;
  c.query = query_guarded;
  c.get_eoa = guarded_end_of_addresses;
  c.set_eoa = set_guarded_end_of_addresses;
  c.get_eof = guarded_end_of_file;
  c.read = read_guarded;
  c.write = refuse_to_write;
  for (H5FD_mem_t& type : c.fl_map) type = H5FD_MEM_SUPER;  // one free list for all
  return c;
}

bool has_lengths_of_dumps(hid_t file) {
  const Handle creation(H5Fget_create_plist(file), H5Pclose);
  std::size_t address_bytes = 0, length_bytes = 0;
  return H5Pget_sizes(creation.id(), &address_bytes, &length_bytes) >= 0 &&
         length_bytes == kLengthBytes;
}

}  // namespace

Handle open_to_read(const std::string& name, hid_t access) {
  const H5FD_class_t driver = guarded_class();
  // An open file keeps its driver.
  const Handle id(H5FDregister(&driver), H5FDunregister);
  const Handle list(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  const GuardedInfo info = {access};
  if (!id.ok() || H5Pset_driver(list.id(), id.id(), &info) < 0) return {};
  Handle file(H5Fopen(name.c_str(), H5F_ACC_RDONLY, list.id()), H5Fclose);
  if (!file.ok() || !has_lengths_of_dumps(file.id())) return {};
  return file;
}

}  // namespace pentimento::hdf5

#include "formats/hdf5/output_driver.h"

#include <H5FDpublic.h>
#if H5_VERSION_GE(1, 13, 0)
#include <H5FDdevelop.h>
#endif

#include <cstring>
#include <new>

namespace pentimento::hdf5 {

namespace {

/// HDF5's own part must come first.
struct DriverFile {
  H5FD_t base;
  OutputFile* output;
  haddr_t end_of_addresses;
  haddr_t end_of_file;
};

/// The driver's information in the access list.
struct DriverInfo {
  OutputFile* output;
};

DriverFile& file_of(H5FD_t* file) {
  return *reinterpret_cast<DriverFile*>(file);
}
const DriverFile& file_of(const H5FD_t* file) {
  return *reinterpret_cast<const DriverFile*>(file);
}

H5FD_t* open_file(const char*, unsigned, hid_t access, haddr_t) {
  const auto* info = static_cast<const DriverInfo*>(H5Pget_driver_info(access));
  if (info == nullptr) return nullptr;
  auto* file = new (std::nothrow) DriverFile{};
  if (file == nullptr) return nullptr;
  file->output = info->output;
  return &file->base;
}

herr_t close_file(H5FD_t* file) {
  delete &file_of(file);
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  if (flags != nullptr) *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA;
  return 0;
}

haddr_t end_of_addresses(const H5FD_t* file, H5FD_mem_t) {
  return file_of(file).end_of_addresses;
}
herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  file_of(file).end_of_addresses = address;
  return 0;
}
haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) {
  return file_of(file).end_of_file;
}

/// Bytes that were never written read as zeros, and so do all bytes after a failure.
herr_t read_file(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* buffer) {
  std::memset(buffer, 0, size);
  file_of(file).output->read_at(address, buffer, size);
  return 0;
}

herr_t write_file(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, std::size_t size,
                  const void* buffer) {
  DriverFile& f = file_of(file);
  f.output->seek(address);
  f.output->write(buffer, size);
  if (address + size > f.end_of_file) f.end_of_file = address + size;
  return 0;
}

/// The file must be as long as HDF5 has given out addresses.
herr_t truncate_file(H5FD_t* file, hid_t, hbool_t) {
  DriverFile& f = file_of(file);
  if (f.end_of_addresses <= f.end_of_file) return 0;
  constexpr char kZero = 0;
  return write_file(file, H5FD_MEM_DEFAULT, H5P_DEFAULT, f.end_of_addresses - 1, 1, &kZero);
}

H5FD_class_t driver_class() {
  H5FD_class_t c = {};
#if H5_VERSION_GE(1, 13, 0)
  c.version = H5FD_CLASS_VERSION;
  c.value = static_cast<H5FD_class_value_t>(512);  // from the range that is free for any use
#endif
  c.name = "pentimento";
  c.maxaddr = static_cast<haddr_t>(INT64_MAX);
  c.fc_degree = H5F_CLOSE_STRONG;
  c.fapl_size = sizeof(DriverInfo);
  c.open = open_file;
  c.close = close_file;
  c.query = query;
  c.get_eoa = end_of_addresses;
  c.set_eoa = set_end_of_addresses;
  c.get_eof = end_of_file;
  c.read = read_file;
  c.write = write_file;
  c.truncate = truncate_file;
  for (H5FD_mem_t& type : c.fl_map) type = H5FD_MEM_SUPER;  // one free list for all
  return c;
}

}  // namespace

OutputDriver::OutputDriver(OutputFile& output) : output_(output) {
  const H5FD_class_t driver = driver_class();
  driver_ = Handle(H5FDregister(&driver), H5FDunregister);
}

Handle OutputDriver::create() {
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  const DriverInfo info = {&output_};
  if (!driver_.ok() || H5Pset_driver(access.id(), driver_.id(), &info) < 0) return {};
  return {H5Fcreate("state", H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose};
}

}  // namespace pentimento::hdf5

#include "formats/hdf5/objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace pentimento::hdf5 {

namespace {

/// The library holds a whole chunk in memory. A row of the widest canvas with 38 bands, which is
/// the largest chunk that is written, has 10 MB.
constexpr std::uint64_t kMostChunkBytes = std::uint64_t{64} << 20;
/// Deflate packs 1032 bytes into one at best.
constexpr std::uint64_t kBestPacking = 1032;
/// The emptiest canvas that is written: of its up to 700 planes the few that are not zero are even,
/// and are packed 230 times (measured). Small canvases need not ask.
constexpr std::uint64_t kMostValuesPerByte = 8192;
constexpr std::uint64_t kAlwaysHeld = std::uint64_t{256} << 20;

bool is_hard_link(hid_t file, const std::string& name, H5L_info_t& info) {
  return H5Lexists(file, name.c_str(), H5P_DEFAULT) > 0 &&
         H5Lget_info(file, name.c_str(), &info, H5P_DEFAULT) >= 0 && info.type == H5L_TYPE_HARD;
}

/// The first step on the way to `name` that is no hard link; empty if all are. Each step is looked
/// at before the next is asked for, so that no link is followed.
std::string first_gap(hid_t file, const std::string& name) {
  H5L_info_t info;
  for (std::size_t slash = name.find('/', 1);; slash = name.find('/', slash + 1)) {
    const std::string step = name.substr(0, slash);
    if (!is_hard_link(file, step, info)) return step;
    if (slash == std::string::npos) return {};
  }
}

/// What a link is that no dump has; empty if there is nothing.
std::string link_problem(hid_t file, const std::string& step) {
  H5L_info_t info;
  if (is_hard_link(file, step, info) || H5Lexists(file, step.c_str(), H5P_DEFAULT) <= 0) return {};
  if (H5Lget_info(file, step.c_str(), &info, H5P_DEFAULT) < 0) return step + " cannot be read";
  if (info.type == H5L_TYPE_SOFT) return step + " is a soft link, which is not followed";
  return step + " is a link to another file, which is not followed";
}

H5O_type_t kind_of(hid_t object) {
  H5O_info_t info;
  return H5Oget_info(object, &info) < 0 ? H5O_TYPE_UNKNOWN : info.type;
}

/// The object at the end of hard links, if it is of this kind.
Handle open_kind(hid_t file, const std::string& name, H5O_type_t kind) {
  if (!holds(file, name)) return {};
  Handle object(H5Oopen(file, name.c_str(), H5P_DEFAULT), H5Oclose);
  if (!object.ok() || kind_of(object.id()) != kind) return {};
  return object;
}

std::string type_problem(hid_t dataset) {
  const Handle type(H5Dget_type(dataset), H5Tclose);
  if (!type.ok()) return "has a type that cannot be read";
  if (H5Tis_variable_str(type.id()) > 0 || is_plain_number(type.id())) return {};
  return "has values of a type that no dump has";
}

/// Filters other than shuffle and deflate may be loaded from libraries, and a filter that is there
/// often multiplies what it unpacks.
std::string filter_problem(hid_t list) {
  const int filters = H5Pget_nfilters(list);
  if (filters < 0 || filters > 2) return "is packed by filters that no dump has";
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0, config = 0;
    std::size_t count = 0;
    const H5Z_filter_t filter = H5Pget_filter2(list, static_cast<unsigned>(i), &flags, &count,
                                               nullptr, 0, nullptr, &config);
    if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE)
      return fmt::format("is packed by filter {}, which no dump has", static_cast<int>(filter));
  }
  return {};
}

/// What a dataset takes, in bytes.
struct Extent {
  std::uint64_t values = 0;  // all of them
  std::uint64_t stored = 0;  // what the file has of them, packed
  std::uint64_t chunks = 0;  // those that the file has, unpacked; 0 without chunks
  std::uint64_t chunk = 0;
};

bool multiply(std::uint64_t& product, std::uint64_t factor) {
  return !__builtin_mul_overflow(product, factor, &product);
}

/// False if numbers cannot be read, or are too large to be true.
bool measure(hid_t dataset, hid_t list, Extent& extent) {
  const Handle space(H5Dget_space(dataset), H5Sclose);
  const Handle type(H5Dget_type(dataset), H5Tclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank < 0 || rank > H5S_MAX_RANK) return false;
  std::array<hsize_t, H5S_MAX_RANK> shape{}, chunk{};
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  extent.values = H5Tget_size(type.id());
  for (int i = 0; i < rank; ++i)
    if (!multiply(extent.values, shape[static_cast<std::size_t>(i)])) return false;
  extent.stored = H5Dget_storage_size(dataset);
  if (H5Pget_layout(list) != H5D_CHUNKED) return true;
  if (H5Pget_chunk(list, H5S_MAX_RANK, chunk.data()) != rank) return false;
  extent.chunk = H5Tget_size(type.id());
  for (int i = 0; i < rank; ++i)
    if (!multiply(extent.chunk, chunk[static_cast<std::size_t>(i)])) return false;
  hsize_t count = 0;
  if (extent.values > 0 && H5Dget_num_chunks(dataset, space.id(), &count) < 0) return false;
  extent.chunks = extent.chunk;
  return multiply(extent.chunks, count);
}

std::string size_problem(hid_t file, hid_t dataset, hid_t list) {
  hsize_t file_bytes = 0;
  Extent extent;
  if (H5Fget_filesize(file, &file_bytes) < 0 || !measure(dataset, list, extent))
    return "has a size that cannot be true";
  if (extent.stored > file_bytes)
    return fmt::format("takes {} bytes of a file of {}", extent.stored, file_bytes);
  if (extent.chunk > kMostChunkBytes)
    return fmt::format("has chunks of {} bytes, must be at most {}", extent.chunk, kMostChunkBytes);
  if (extent.chunks > kBestPacking * extent.stored + extent.chunk)
    return fmt::format("has {} bytes packed in {}", extent.chunks, extent.stored);
  return {};
}

std::string storage_problem(hid_t file, hid_t dataset) {
  const Handle list(H5Dget_create_plist(dataset), H5Pclose);
  if (!list.ok()) return "cannot be read";
  const H5D_layout_t layout = H5Pget_layout(list.id());
  if (layout == H5D_VIRTUAL) return "is a virtual dataset, which reads other files";
  if (layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED)
    return "has a layout that is not known here";
  if (H5Pget_external_count(list.id()) != 0) return "has its values in another file";
  std::string problem = filter_problem(list.id());
  if (problem.empty()) problem = type_problem(dataset);
  if (problem.empty()) problem = size_problem(file, dataset, list.id());
  return problem;
}

}  // namespace

void load_no_filters() {
  H5PLset_loading_state(0);
}

bool holds(hid_t file, const std::string& name) {
  return first_gap(file, name).empty();
}

bool lacks(hid_t file, const std::string& name) {
  const std::string gap = first_gap(file, name);
  return !gap.empty() && link_problem(file, gap).empty();
}

std::string dataset_problem(hid_t file, const std::string& name) {
  const std::string gap = first_gap(file, name);
  if (!gap.empty()) return link_problem(file, gap);
  const Handle dataset = open_kind(file, name, H5O_TYPE_DATASET);
  if (!dataset.ok()) return name + " is not a dataset";
  const std::string problem = storage_problem(file, dataset.id());
  return problem.empty() ? "" : name + " " + problem;
}

Handle open_dataset(hid_t file, const std::string& name) {
  if (!dataset_problem(file, name).empty()) return {};
  return open_kind(file, name, H5O_TYPE_DATASET);
}

Handle open_group(hid_t file, const std::string& name) {
  return open_kind(file, name, H5O_TYPE_GROUP);
}

bool may_hold(hid_t file, std::uint64_t bytes) {
  hsize_t file_bytes = 0;
  if (H5Fget_filesize(file, &file_bytes) < 0) return false;
  return bytes <= kAlwaysHeld || bytes / kMostValuesPerByte <= file_bytes;
}

bool is_plain_number(hid_t type) {
  const hid_t plain[] = {
      H5T_IEEE_F32LE, H5T_IEEE_F32BE, H5T_IEEE_F64LE, H5T_IEEE_F64BE, H5T_STD_I8LE,  H5T_STD_I16LE,
      H5T_STD_I16BE,  H5T_STD_I32LE,  H5T_STD_I32BE,  H5T_STD_I64LE,  H5T_STD_I64BE, H5T_STD_U8LE,
      H5T_STD_U16LE,  H5T_STD_U16BE,  H5T_STD_U32LE,  H5T_STD_U32BE,  H5T_STD_U64LE, H5T_STD_U64BE};
  return std::any_of(std::begin(plain), std::end(plain),
                     [&](hid_t known) { return H5Tequal(type, known) > 0; });
}

}  // namespace pentimento::hdf5

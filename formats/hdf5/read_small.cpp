#include "formats/hdf5/read_small.h"

#include <cstring>

#include "formats/hdf5/objects.h"
#include "formats/hdf5/state_dump.h"
#include "formats/io/utf8.h"

namespace pentimento::hdf5 {

namespace {

constexpr std::size_t kLongestText = std::size_t{16} << 20;

Handle open_attribute(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return {};
  return {H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose};
}

bool is_scalar(hid_t attribute) {
  const Handle space(H5Aget_space(attribute), H5Sclose);
  return space.ok() && H5Sget_simple_extent_npoints(space.id()) == 1;
}

/// Whether it is one string, be it readable or not.
bool holds_text(const Handle& attribute) {
  if (!attribute.ok() || !is_scalar(attribute.id())) return false;
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  return H5Tget_class(type.id()) == H5T_STRING;
}

/// A copy of the file's own string type, so that no character set has to be converted.
std::optional<std::string> fixed_text(hid_t attribute, hid_t type) {
  const std::size_t size = H5Tget_size(type);
  if (size == 0 || size > kLongestText) return std::nullopt;
  std::string text(size, '\0');
  if (H5Aread(attribute, type, text.data()) < 0) return std::nullopt;
  return valid_utf8(text.c_str());
}

std::optional<std::string> variable_text(hid_t attribute, hid_t type) {
  char* value = nullptr;
  if (H5Aread(attribute, type, static_cast<void*>(&value)) < 0 || value == nullptr)
    return std::nullopt;
  std::string text = valid_utf8(value);
  H5free_memory(value);
  return text;
}

template <typename T>
std::optional<T> scalar(hid_t object, const std::string& name, hid_t memory_type) {
  const Handle attribute = open_attribute(object, name);
  if (!attribute.ok() || !is_scalar(attribute.id())) return std::nullopt;
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  if (!is_plain_number(type.id())) return std::nullopt;
  T value{};
  if (H5Aread(attribute.id(), memory_type, &value) < 0) return std::nullopt;
  return value;
}

template <typename T>
std::optional<std::vector<T>> read_values(hid_t file, const std::string& name,
                                          const std::vector<std::uint64_t>& shape,
                                          hid_t memory_type) {
  if (dataset_shape(file, name) != shape) return std::nullopt;
  std::uint64_t count = 1;
  for (const std::uint64_t n : shape)
    if (__builtin_mul_overflow(count, n, &count)) return std::nullopt;
  if (!may_hold(file, count * sizeof(T))) return std::nullopt;
  std::vector<T> values(count);
  if (count == 0) return values;
  const Handle dataset = open_dataset(file, name);
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (!is_plain_number(type.id())) return std::nullopt;
  if (H5Dread(dataset.id(), memory_type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    return std::nullopt;
  return values;
}

}  // namespace

bool has_attribute(hid_t object, const std::string& name) {
  return H5Aexists(object, name.c_str()) != 0;
}

std::optional<std::string> text_attribute(hid_t object, const std::string& name) {
  const Handle attribute = open_attribute(object, name);
  if (!holds_text(attribute)) return std::nullopt;
  const Handle type(H5Aget_type(attribute.id()), H5Tclose);
  return H5Tis_variable_str(type.id()) > 0 ? variable_text(attribute.id(), type.id())
                                           : fixed_text(attribute.id(), type.id());
}

std::optional<double> number_attribute(hid_t object, const std::string& name) {
  return scalar<double>(object, name, H5T_NATIVE_DOUBLE);
}

std::optional<std::int64_t> whole_attribute(hid_t object, const std::string& name) {
  return scalar<std::int64_t>(object, name, H5T_NATIVE_INT64);
}

std::string format_problem(hid_t root) {
  const std::optional<std::string> format = text_attribute(root, "format");
  if (format == kStateFormat) return {};
  if (!format && holds_text(open_attribute(root, "format")))
    return "a damaged HDF5 file: what it says of its format cannot be read";
  return "an HDF5 file, but not a state dump";
}

Provenance text_attributes(hid_t object) {
  Provenance found;
  const auto visit = [](hid_t where, const char* name, const H5A_info_t*, void* out) -> herr_t {
    if (std::optional<std::string> text = text_attribute(where, name))
      static_cast<Provenance*>(out)->emplace_back(name, std::move(*text));
    return 0;
  };
  hsize_t start = 0;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, &start, visit, &found);
  return found;
}

std::optional<std::vector<std::uint64_t>> dataset_shape(hid_t file, const std::string& name) {
  const Handle dataset = open_dataset(file, name);
  if (!dataset.ok()) return std::nullopt;
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int rank = H5Sget_simple_extent_ndims(space.id());
  if (rank < 0 || rank > H5S_MAX_RANK) return std::nullopt;
  hsize_t shape[H5S_MAX_RANK] = {};
  H5Sget_simple_extent_dims(space.id(), shape, nullptr);
  return std::vector<std::uint64_t>(shape, shape + rank);
}

std::optional<std::vector<double>> read_doubles(hid_t file, const std::string& name,
                                                const std::vector<std::uint64_t>& shape) {
  return read_values<double>(file, name, shape, H5T_NATIVE_DOUBLE);
}

std::optional<std::vector<std::uint32_t>> read_words(hid_t file, const std::string& name,
                                                     const std::vector<std::uint64_t>& shape) {
  return read_values<std::uint32_t>(file, name, shape, H5T_NATIVE_UINT32);
}

std::optional<std::vector<std::string>> read_strings(hid_t file, const std::string& name,
                                                     std::size_t most) {
  const auto shape = dataset_shape(file, name);
  if (!shape || shape->size() != 1 || shape->front() > most) return std::nullopt;
  const Handle dataset = open_dataset(file, name);
  const Handle type(H5Dget_type(dataset.id()), H5Tclose);
  if (H5Tis_variable_str(type.id()) <= 0) return std::nullopt;
  std::vector<char*> pointers(shape->front(), nullptr);
  if (pointers.empty()) return std::vector<std::string>();
  // Many names may lie in the same few bytes of the file.
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  hsize_t bytes = 0;
  if (H5Dvlen_get_buf_size(dataset.id(), type.id(), space.id(), &bytes) < 0 || bytes > kLongestText)
    return std::nullopt;
  if (H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, pointers.data()) < 0)
    return std::nullopt;
  std::vector<std::string> texts;
  for (char* text : pointers) {
    texts.push_back(valid_utf8(text == nullptr ? "" : text));
    if (text != nullptr) H5free_memory(text);
  }
  return texts;
}

}  // namespace pentimento::hdf5

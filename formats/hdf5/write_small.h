#pragma once
// Writes attributes and small datasets. For the .cpp files of this folder only. A function returns
// false on failure; HDF5 in memory fails only if there is no more memory.

#include <hdf5.h>

#include <string>
#include <string_view>
#include <vector>

#include "formats/hdf5/handle.h"

namespace pentimento::hdf5 {

bool set_attribute(hid_t object, const std::string& name, std::string_view text);
bool set_attribute(hid_t object, const std::string& name, double value);
bool set_attribute(hid_t object, const std::string& name, float value);
bool set_attribute(hid_t object, const std::string& name, std::int64_t value);

/// Sets `units` and `long_name`, the attributes of every dataset.
bool describe(hid_t dataset, const char* units, const char* long_name);

struct SmallDataset {
  const char* name;
  const char* units;
  const char* long_name;
  std::vector<hsize_t> shape;
};
bool write_small(hid_t file, const SmallDataset& dataset, const std::vector<double>& values);
bool write_small(hid_t file, const SmallDataset& dataset, const std::vector<float>& values);
/// A list of UTF-8 strings; `shape` is ignored.
bool write_small(hid_t file, const SmallDataset& dataset, const std::vector<std::string>& values);

bool make_group(hid_t file, const char* name);

}  // namespace pentimento::hdf5

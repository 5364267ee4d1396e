#include "formats/hdf5/write_small.h"

#include "formats/io/utf8.h"

namespace pentimento::hdf5 {

namespace {

Handle string_type() {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

bool set_scalar(hid_t object, const std::string& name, hid_t type, const void* value) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Handle attribute(
      H5Acreate2(object, name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.ok() && H5Awrite(attribute.id(), type, value) >= 0;
}

bool write_array(hid_t file, const SmallDataset& what, const std::vector<hsize_t>& shape,
                 hid_t type, const void* values) {
  const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                     H5Sclose);
  const Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(list.id(), false);
  const Handle dataset(
      H5Dcreate2(file, what.name, type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT), H5Dclose);
  if (!dataset.ok()) return false;
  const bool empty = H5Sget_simple_extent_npoints(space.id()) == 0;
  if (!empty && H5Dwrite(dataset.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values) < 0)
    return false;
  return describe(dataset.id(), what.units, what.long_name);
}

}  // namespace

bool set_attribute(hid_t object, const std::string& name, std::string_view text) {
  const std::string valid = valid_utf8(text);
  const char* value = valid.c_str();
  return set_scalar(object, name, string_type().id(), static_cast<const void*>(&value));
}
bool set_attribute(hid_t object, const std::string& name, double value) {
  return set_scalar(object, name, H5T_NATIVE_DOUBLE, &value);
}
bool set_attribute(hid_t object, const std::string& name, float value) {
  return set_scalar(object, name, H5T_NATIVE_FLOAT, &value);
}
bool set_attribute(hid_t object, const std::string& name, std::int64_t value) {
  return set_scalar(object, name, H5T_NATIVE_INT64, &value);
}

bool describe(hid_t dataset, const char* units, const char* long_name) {
  return set_attribute(dataset, "units", std::string_view(units)) &&
         set_attribute(dataset, "long_name", std::string_view(long_name));
}

bool write_small(hid_t file, const SmallDataset& dataset, const std::vector<double>& values) {
  return write_array(file, dataset, dataset.shape, H5T_NATIVE_DOUBLE, values.data());
}
bool write_small(hid_t file, const SmallDataset& dataset, const std::vector<float>& values) {
  return write_array(file, dataset, dataset.shape, H5T_NATIVE_FLOAT, values.data());
}
bool write_small(hid_t file, const SmallDataset& dataset, const std::vector<std::string>& values) {
  std::vector<std::string> valid;
  for (const std::string& text : values) valid.push_back(valid_utf8(text));
  std::vector<const char*> pointers;
  for (const std::string& text : valid) pointers.push_back(text.c_str());
  return write_array(file, dataset, {pointers.size()}, string_type().id(), pointers.data());
}

bool make_group(hid_t file, const char* name) {
  const Handle group(H5Gcreate2(file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  return group.ok();
}

}  // namespace pentimento::hdf5

#include "tests/fuzz/dump_editor.h"

#include <array>
#include <cstdint>
#include <limits>

#include "formats/hdf5/handle.h"

namespace pentimento::test {

namespace {

using hdf5::Handle;

/// Side lengths: those of the small dump, their neighbours, and some that no memory holds.
constexpr std::array<hsize_t, 16> kExtents = {0,
                                              1,
                                              2,
                                              3,
                                              4,
                                              7,
                                              9,
                                              14,
                                              18,
                                              64,
                                              1024,
                                              65536,
                                              65537,
                                              hsize_t{1} << 31,
                                              hsize_t{1} << 32,
                                              hsize_t{1} << 62};
constexpr std::array<double, 16> kNumbers = {
    0,     -0.0, 1,    -1,   0.5,   2,     3,          1e-45,
    1e-30, 1e9,  1e12, 3e38, 1e300, 65536, 4294967296, 9007199254740994};

struct Names {
  std::vector<std::string>& datasets;
  std::vector<std::string>& groups;
};

herr_t note_name(hid_t, const char* name, const H5O_info_t* info, void* to) {
  auto& names = *static_cast<Names*>(to);
  const std::string path = std::string("/") + (std::string(name) == "." ? "" : name);
  if (info->type == H5O_TYPE_DATASET) names.datasets.push_back(path);
  if (info->type == H5O_TYPE_GROUP) names.groups.push_back(path);
  return 0;
}

herr_t note_attribute(hid_t, const char* name, const H5A_info_t*, void* to) {
  static_cast<std::vector<std::string>*>(to)->emplace_back(name);
  return 0;
}

std::vector<std::string> attributes_of(hid_t object) {
  std::vector<std::string> names;
  hsize_t at = 0;
  H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_NATIVE, &at, note_attribute, &names);
  return names;
}

}  // namespace

DumpEditor::DumpEditor(hid_t file, Choices& choices) : file_(file), choices_(choices) {
  Names names{datasets_, groups_};
#if H5_VERSION_GE(1, 12, 0)
  H5Ovisit1(file, H5_INDEX_NAME, H5_ITER_NATIVE, note_name, &names);
#else
  H5Ovisit(file, H5_INDEX_NAME, H5_ITER_NATIVE, note_name, &names);
#endif
}

void DumpEditor::edit() {
  using Edit = void (DumpEditor::*)();
  constexpr Edit kEdits[] = {&DumpEditor::set_value,       &DumpEditor::set_value,
                             &DumpEditor::set_attribute,   &DumpEditor::set_attribute,
                             &DumpEditor::replace_dataset, &DumpEditor::replace_dataset,
                             &DumpEditor::remove,          &DumpEditor::remove_attribute,
                             &DumpEditor::link_elsewhere,  &DumpEditor::move};
  (this->*choices_.of(kEdits))();
}

double DumpEditor::some_number() {
  switch (choices_.below(8)) {
    case 0:
      return std::numeric_limits<double>::quiet_NaN();
    case 1:
      return (choices_.flag() ? 1 : -1) * std::numeric_limits<double>::infinity();
    case 2:
      return choices_.byte() - 128;
    case 3:
      return -choices_.of(kNumbers);
    case 4:
      return choices_.between(0, 1);
    default:
      return choices_.of(kNumbers);
  }
}

/// The caller closes it; closing one of the library's own does nothing.
hid_t DumpEditor::some_type() {
  switch (choices_.below(12)) {
    case 0:
      return H5Tcopy(H5T_NATIVE_DOUBLE);
    case 1:
      return H5Tcopy(H5T_STD_U32LE);
    case 2:
      return H5Tcopy(H5T_STD_I8LE);
    case 3:
      return H5Tcopy(H5T_IEEE_F32BE);
    case 4:
      return H5Tcopy(H5T_STD_I64BE);
    case 5: {
      const hid_t text = H5Tcopy(H5T_C_S1);
      H5Tset_size(text, choices_.flag() ? H5T_VARIABLE : 1u + choices_.byte());
      return text;
    }
    case 6: {
      const hid_t pair = H5Tcreate(H5T_COMPOUND, 8);
      H5Tinsert(pair, "a", 0, H5T_IEEE_F32LE);
      H5Tinsert(pair, "b", 4, H5T_STD_U32LE);
      return pair;
    }
    case 7: {
      const hsize_t sides[2] = {3, 1u + choices_.byte()};
      return H5Tarray_create2(H5T_IEEE_F32LE, 2, sides);
    }
    case 8:
      return H5Tvlen_create(H5T_IEEE_F32LE);
    case 9:
      return H5Tcreate(H5T_OPAQUE, 1u + choices_.byte());
    case 10: {
      const hid_t odd = H5Tcopy(H5T_IEEE_F64LE);  // a format that no processor has
      H5Tset_fields(odd, 40, 30, 8, 0, 8 + choices_.below(20));
      return odd;
    }
    default:
      return H5Tcopy(H5T_IEEE_F32LE);
  }
}

void DumpEditor::set_value() {
  const Handle dataset(H5Dopen2(file_, some_dataset().c_str(), H5P_DEFAULT), H5Dclose);
  const Handle space(H5Dget_space(dataset.id()), H5Sclose);
  std::array<hsize_t, 8> shape{}, at{};
  const int rank = H5Sget_simple_extent_ndims(space.id());
  // Writing one value makes the library store all of them.
  constexpr hssize_t kMostValues = 1 << 16;
  if (!dataset.ok() || rank < 1 || rank > 8 ||
      H5Sget_simple_extent_npoints(space.id()) > kMostValues)
    return;
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rank); ++i) {
    if (shape[i] == 0) return;
    at[i] = choices_.byte() % shape[i];
  }
  H5Sselect_elements(space.id(), H5S_SELECT_SET, 1, at.data());
  const hsize_t one = 1;
  const Handle memory(H5Screate_simple(1, &one, nullptr), H5Sclose);
  const double value = some_number();
  H5Dwrite(dataset.id(), H5T_NATIVE_DOUBLE, memory.id(), space.id(), H5P_DEFAULT, &value);
}

void DumpEditor::set_attribute() {
  const Handle group(H5Gopen2(file_, choices_.of(groups_).c_str(), H5P_DEFAULT), H5Gclose);
  const std::vector<std::string> names = attributes_of(group.id());
  if (names.empty()) return;
  const std::string& name = choices_.of(names);
  const double value = some_number();
  const Handle old(H5Aopen(group.id(), name.c_str(), H5P_DEFAULT), H5Aclose);
  if (choices_.flag()) {
    H5Awrite(old.id(), H5T_NATIVE_DOUBLE, &value);
    return;
  }
  H5Adelete(group.id(), name.c_str());
  const Handle type(some_type(), H5Tclose);
  const hsize_t sides[2] = {choices_.below(4), 1 + choices_.below(3)};
  const Handle space(choices_.flag() ? H5Screate(H5S_SCALAR) : H5Screate_simple(2, sides, nullptr),
                     H5Sclose);
  const Handle made(
      H5Acreate2(group.id(), name.c_str(), type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  const H5T_class_t kind = H5Tget_class(type.id());
  if (kind == H5T_STRING && H5Tis_variable_str(type.id()) == 0) {
    std::string text(4096, static_cast<char>(choices_.byte()));
    H5Awrite(made.id(), type.id(), text.data());
  } else if (kind == H5T_FLOAT || kind == H5T_INTEGER) {
    const std::vector<double> values(16, value);
    H5Awrite(made.id(), H5T_NATIVE_DOUBLE, values.data());
  }
}

void DumpEditor::remove() {
  H5Ldelete(file_, (choices_.byte() % 4 == 0 ? choices_.of(groups_) : some_dataset()).c_str(),
            H5P_DEFAULT);
}

void DumpEditor::replace_dataset() {
  const std::string& name = some_dataset();
  std::array<hsize_t, 5> shape{}, chunk{};
  const std::size_t rank = choices_.below(6);
  for (std::size_t i = 0; i < rank; ++i) {
    shape[i] = choices_.of(kExtents);
    chunk[i] = 1 + choices_.below(16);
  }
  H5Ldelete(file_, name.c_str(), H5P_DEFAULT);
  const Handle type(some_type(), H5Tclose);
  const Handle space(H5Screate_simple(static_cast<int>(rank), shape.data(), nullptr), H5Sclose);
  const Handle how(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  const std::size_t layout = choices_.below(6);
  if (layout == 1 || layout == 2) H5Pset_chunk(how.id(), static_cast<int>(rank), chunk.data());
  if (layout == 2) H5Pset_deflate(how.id(), 1);
  if (layout == 3) H5Pset_layout(how.id(), H5D_COMPACT);
  if (layout == 4) H5Pset_external(how.id(), "/dev/zero", 0, H5F_UNLIMITED);
  if (layout == 5) H5Pset_virtual(how.id(), space.id(), "other.h5", "/a", space.id());
  if (choices_.flag()) {
    const double value = some_number();
    H5Pset_fill_value(how.id(), H5T_NATIVE_DOUBLE, &value);
  }
  const Handle made(
      H5Dcreate2(file_, name.c_str(), type.id(), space.id(), H5P_DEFAULT, how.id(), H5P_DEFAULT),
      H5Dclose);
}

void DumpEditor::link_elsewhere() {
  const std::string& name = choices_.byte() % 4 == 0 ? choices_.of(groups_) : some_dataset();
  const std::string& to = choices_.byte() % 4 == 0 ? choices_.of(groups_) : some_dataset();
  H5Ldelete(file_, name.c_str(), H5P_DEFAULT);
  switch (choices_.below(3)) {
    case 0:
      H5Lcreate_soft(to.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    case 1:
      H5Lcreate_external("other.h5", to.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
      break;
    default:
      H5Lcreate_hard(file_, to.c_str(), file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
  }
}

void DumpEditor::move() {
  const std::string& from = some_dataset();
  const std::string& to = some_dataset();
  H5Ldelete(file_, to.c_str(), H5P_DEFAULT);
  H5Lmove(file_, from.c_str(), file_, to.c_str(), H5P_DEFAULT, H5P_DEFAULT);
}

void DumpEditor::remove_attribute() {
  const Handle group(H5Gopen2(file_, choices_.of(groups_).c_str(), H5P_DEFAULT), H5Gclose);
  const std::vector<std::string> names = attributes_of(group.id());
  if (!names.empty()) H5Adelete(group.id(), choices_.of(names).c_str());
}

}  // namespace pentimento::test

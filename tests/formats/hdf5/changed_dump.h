#pragma once
// A small dump that is changed, for tests of what the reader refuses.

#include <gtest/gtest.h>
#include <hdf5.h>

#include <functional>
#include <string>

#include "formats/hdf5/handle.h"
#include "formats/hdf5/state_dump.h"
#include "tests/formats/hdf5/library_leaks.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"

namespace pentimento::test {

/// A small dump, changed through HDF5's own functions, and what reading it says.
class ChangedDump : public testing::Test {
 private:
  // From before the library allocates anything: what it loses it may have had before the breakage.
  const IgnoreLibraryLeaks ignore_;

 protected:
  /// The dump as it was.
  void mend() { ASSERT_TRUE(write_state(path_, made_up_dump(9, 7, 2, 3), {})); }
  void SetUp() override {
    mend();
    const auto back = read_state(path_);
    ASSERT_TRUE(back) << back.error().message;
  }

  /// Error message without the file's name; "fine" if there is none.
  std::string after(const std::function<void(hid_t)>& change) {
    {
      const Handle file(H5Fopen(path_.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
      change(file.id());
    }
    const auto dump = read_state(path_);
    if (dump) return "fine";
    code_ = dump.error().code;
    EXPECT_EQ(dump.error().message.find(path_ + ": "), 0u) << dump.error().message;
    return dump.error().message.substr(path_.size() + 2);
  }

  using Handle = hdf5::Handle;

  static void set_number(hid_t file, const char* name, double value) {
    const Handle attribute(H5Aopen(file, name, H5P_DEFAULT), H5Aclose);
    H5Awrite(attribute.id(), H5T_NATIVE_DOUBLE, &value);
  }
  static void set_float(hid_t file, const char* name, float value, hsize_t row = 4,
                        hsize_t column = 5) {
    const Handle dataset(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const hsize_t one = 1;
    const hsize_t at[2] = {row, column};
    const Handle memory(H5Screate_simple(1, &one, nullptr), H5Sclose);
    const Handle space(H5Dget_space(dataset.id()), H5Sclose);
    H5Sselect_elements(space.id(), H5S_SELECT_SET, 1, at);
    H5Dwrite(dataset.id(), H5T_NATIVE_FLOAT, memory.id(), space.id(), H5P_DEFAULT, &value);
  }

  const Scratch scratch_;
  const std::string path_ = scratch_.path("a.h5");
  ErrorCode code_ = ErrorCode::kIo;
};

}  // namespace pentimento::test

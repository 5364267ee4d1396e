#include "formats/hdf5/input_driver.h"

#include <gtest/gtest.h>

#include <string>

#include "formats/hdf5/read_small.h"
#include "tests/formats/hdf5/changed_dump.h"
#include "tests/formats/hdf5/dump_image.h"

namespace pentimento {
namespace {

class GuardedDump : public test::ChangedDump {
 protected:
  /// Makes the first object of each global heap a free one without any room.
  void break_heaps() {
    std::string bytes = test::slurp(path_);
    constexpr std::size_t kFirstObject = 16, kObjectHeader = 16;
    std::size_t at = bytes.find("GCOL");
    ASSERT_NE(at, std::string::npos);
    for (; at != std::string::npos; at = bytes.find("GCOL", at + 1))
      bytes.replace(at + kFirstObject, kObjectHeader, kObjectHeader, '\0');
    test::spill(path_, bytes);
  }
  const hdf5::Silence silence_;
};

TEST_F(GuardedDump, ReadsWhatTheLibraryReads) {
  const Handle file = hdf5::open_to_read(path_);
  ASSERT_TRUE(file.ok());
  const Handle root(H5Gopen2(file.id(), "/", H5P_DEFAULT), H5Gclose);
  EXPECT_EQ(hdf5::text_attribute(root.id(), "format"), kStateFormat);
  const auto names = hdf5::read_strings(file.id(), "/layers/channel", 100);
  ASSERT_TRUE(names);
  EXPECT_EQ(names->size(), 3u);
}

TEST_F(GuardedDump, ATextInAHeapWithoutEndCannotBeRead) {
  break_heaps();
  const Handle file = hdf5::open_to_read(path_);
  ASSERT_TRUE(file.ok());
  EXPECT_EQ(hdf5::read_strings(file.id(), "/layers/channel", 100), std::nullopt);
}

TEST_F(GuardedDump, AHeapWithoutEndIsToldAtOnce) {
  // Without the guard the child that reads the dump first would be ended after its minute.
  break_heaps();
  EXPECT_EQ(after([](hid_t) {}), "a damaged HDF5 file: what it says of its format cannot be read");
  EXPECT_EQ(code_, ErrorCode::kBadInput);
}

TEST_F(GuardedDump, NothingIsWritten) {
  const std::string before = test::slurp(path_);
  {
    const Handle file = hdf5::open_to_read(path_);
    const Handle made(H5Gcreate2(file.id(), "/more", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                      H5Gclose);
    EXPECT_FALSE(made.ok());
  }
  EXPECT_EQ(test::slurp(path_), before);
}

TEST_F(GuardedDump, BytesMayLieInMemory) {
  const std::string bytes = test::slurp(path_);
  const Handle file = hdf5::open_to_read("image", test::access_to_image(bytes).id());
  ASSERT_TRUE(file.ok());
  EXPECT_TRUE(hdf5::read_strings(file.id(), "/layers/channel", 100).has_value());
}

TEST_F(GuardedDump, LengthsOfFourBytesAreRefused) {
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_sizes(creation.id(), 8, 4);
  const std::string path = scratch_.path("short.h5");
  {
    const Handle made(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), H5P_DEFAULT), H5Fclose);
  }
  EXPECT_FALSE(hdf5::open_to_read(path).ok());
  EXPECT_FALSE(hdf5::open_to_read(scratch_.path("missing.h5")).ok());
}

}  // namespace
}  // namespace pentimento

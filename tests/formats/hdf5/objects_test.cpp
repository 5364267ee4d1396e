// A dump that leads out of its file, or promises more than its file has, is refused before anything
// is followed, read or allocated. Where a link or a dataset names another file, that file is a pipe
// into which nobody writes: who opened it would wait for ever.

#include "formats/hdf5/objects.h"

#include <sys/stat.h>

#include <vector>

#include "tests/formats/hdf5/changed_dump.h"

namespace pentimento {
namespace {

using hdf5::Handle;

class HostileDump : public test::ChangedDump {
 protected:
  void SetUp() override {
    ChangedDump::SetUp();
    ASSERT_EQ(mkfifo(trap_.c_str(), 0600), 0);
  }

  /// A dataset of floats in place of that of the name.
  void put(hid_t file, const char* name, hid_t list, const std::vector<hsize_t>& shape,
           hid_t type = H5T_IEEE_F32LE) const {
    if (H5Lexists(file, name, H5P_DEFAULT) > 0) H5Ldelete(file, name, H5P_DEFAULT);
    const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                       H5Sclose);
    const Handle made(H5Dcreate2(file, name, type, space.id(), H5P_DEFAULT, list, H5P_DEFAULT),
                      H5Dclose);
    ASSERT_TRUE(made.ok()) << name;
  }
  static Handle creation() { return {H5Pcreate(H5P_DATASET_CREATE), H5Pclose}; }

  const std::string trap_ = scratch_.path("trap");
};

TEST_F(HostileDump, AnExternalLinkIsNotFollowed) {
  for (const std::string name : {"/fluid/depth", "/layers/K", "/lighting/probe", "/fluid/asleep"}) {
    EXPECT_EQ(after([&](hid_t f) {
                H5Ldelete(f, name.c_str(), H5P_DEFAULT);
                H5Lcreate_external(trap_.c_str(), "/x", f, name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
              }),
              name + " is a link to another file, which is not followed");
    mend();
  }
  EXPECT_EQ(code_, ErrorCode::kBadInput);
}

TEST_F(HostileDump, AGroupThatIsAnExternalLinkIsNotFollowed) {
  EXPECT_EQ(after([&](hid_t f) {
              H5Ldelete(f, "/canvas", H5P_DEFAULT);
              H5Lcreate_external(trap_.c_str(), "/", f, "/canvas", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/canvas is a link to another file, which is not followed");
  EXPECT_EQ(after([&](hid_t f) {
              H5Ldelete(f, "/lighting", H5P_DEFAULT);
              H5Lcreate_external(trap_.c_str(), "/", f, "/lighting", H5P_DEFAULT, H5P_DEFAULT);
            }).find("/canvas is a link"),
            0u);
}

TEST_F(HostileDump, ASoftLinkIsNotFollowed) {
  EXPECT_EQ(after([&](hid_t f) {
              H5Lmove(f, "/layers/load", f, "/layers/other", H5P_DEFAULT, H5P_DEFAULT);
              H5Lcreate_soft("/layers/other", f, "/layers/load", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/layers/load is a soft link, which is not followed");
}

TEST_F(HostileDump, ASecondHardLinkIsTheSameData) {
  EXPECT_EQ(after([&](hid_t f) {
              H5Lcreate_hard(f, "/layers/load", f, "/layers/other", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "fine");
}

TEST_F(HostileDump, ValuesInAnotherFileAreNotRead) {
  const Handle list = creation();
  H5Pset_external(list.id(), trap_.c_str(), 0, 9 * 7 * 4);
  EXPECT_EQ(after([&](hid_t f) {
              put(f, "/fluid/depth", list.id(), {7, 9});
            }),
            "/fluid/depth has its values in another file");
}

TEST_F(HostileDump, AVirtualDatasetIsNotRead) {
  const Handle list = creation();
  const hsize_t shape[] = {7, 9};
  const Handle space(H5Screate_simple(2, shape, nullptr), H5Sclose);
  H5Pset_virtual(list.id(), space.id(), trap_.c_str(), "/x", space.id());
  EXPECT_EQ(after([&](hid_t f) {
              put(f, "/canvas/base", list.id(), {7, 9});
            }),
            "/canvas/base is a virtual dataset, which reads other files");
}

TEST_F(HostileDump, OtherFiltersAreRefused) {
  const Handle checksum = creation();
  const hsize_t chunk[] = {7, 9};
  H5Pset_chunk(checksum.id(), 2, chunk);
  H5Pset_fletcher32(checksum.id());
  EXPECT_EQ(after([&](hid_t f) {
              put(f, "/fluid/depth", checksum.id(), {7, 9});
            }),
            "/fluid/depth is packed by filter 3, which no dump has");
  // One that the library would look for among its plugins.
  const Handle unknown = creation();
  H5Pset_chunk(unknown.id(), 2, chunk);
  H5Pset_filter(unknown.id(), 32015, H5Z_FLAG_OPTIONAL, 0, nullptr);
  EXPECT_EQ(after([&](hid_t f) {
              put(f, "/fluid/depth", unknown.id(), {7, 9});
            }),
            "/fluid/depth is packed by filter 32015, which no dump has");
  const Handle thrice = creation();
  H5Pset_chunk(thrice.id(), 2, chunk);
  for (int i = 0; i < 3; ++i) H5Pset_deflate(thrice.id(), 9);
  EXPECT_EQ(after([&](hid_t f) {
              put(f, "/fluid/depth", thrice.id(), {7, 9});
            }),
            "/fluid/depth is packed by filters that no dump has");
}

TEST_F(HostileDump, OtherTypesAreRefused) {
  const Handle odd(H5Tcopy(H5T_IEEE_F32LE), H5Tclose);
  H5Tset_fields(odd.id(), 31, 23, 8, 3, 20);
  const Handle opaque(H5Tcreate(H5T_OPAQUE, 4), H5Tclose);
  const Handle pair(H5Tcreate(H5T_COMPOUND, 8), H5Tclose);
  H5Tinsert(pair.id(), "a", 0, H5T_IEEE_F32LE);
  for (const hid_t type : {odd.id(), opaque.id(), pair.id(), H5T_STD_REF_OBJ})
    EXPECT_EQ(after([&](hid_t f) {
                put(f, "/fluid/depth", creation().id(), {7, 9}, type);
              }),
              "/fluid/depth has values of a type that no dump has");
  EXPECT_EQ(after([&](hid_t f) {
              H5Ldelete(f, "/fluid/depth", H5P_DEFAULT);
              H5Lcreate_hard(f, "/layers/channel", f, "/layers/K2", H5P_DEFAULT, H5P_DEFAULT);
              H5Ldelete(f, "/layers/K", H5P_DEFAULT);
              H5Lmove(f, "/layers/K2", f, "/layers/K", H5P_DEFAULT, H5P_DEFAULT);
              put(f, "/fluid/depth", creation().id(), {7, 9});
            }),
            "/layers/K is missing or malformed");
}

TEST_F(HostileDump, AGroupIsNoDataset) {
  EXPECT_EQ(after([&](hid_t f) {
              H5Ldelete(f, "/fluid/depth", H5P_DEFAULT);
              H5Lcreate_hard(f, "/canvas", f, "/fluid/depth", H5P_DEFAULT, H5P_DEFAULT);
            }),
            "/fluid/depth is not a dataset");
}

TEST_F(HostileDump, APictureWithoutDataIsNotReadForEver) {
  const Handle list = creation();
  const hsize_t chunk[] = {64, 64, 3};
  H5Pset_chunk(list.id(), 3, chunk);
  EXPECT_EQ(after([&](hid_t f) {
              put(f, "/lighting/reflection", list.id(), {65536, 65536, 3});
            }),
            "/lighting/reflection must be rows x columns x 3, at most 65536 x 65536 and 134217728 "
            "pixels");
  EXPECT_EQ(after([&](hid_t f) {
              put(f, "/lighting/probe", list.id(), {512, 512, 3});
            }).find("/lighting/"),
            0u);
}

TEST_F(HostileDump, ACanvasWithoutDataIsNotTaken) {
  const Handle flat = creation(), deep = creation(), stack = creation();
  const hsize_t chunk[] = {1, 1, 64, 64}, bands[] = {64, 64, 3};
  H5Pset_chunk(flat.id(), 2, chunk + 2);
  H5Pset_chunk(deep.id(), 3, bands);
  H5Pset_chunk(stack.id(), 4, chunk);
  EXPECT_EQ(after([&](hid_t f) {
              put(f, "/fluid/depth", flat.id(), {16384, 16384});
              put(f, "/canvas/reflectance", deep.id(), {16384, 16384, 3});
              put(f, "/layers/pigment", stack.id(), {2, 3, 16384, 16384});
            }),
            "16384 x 16384 cells in 9 planes are more than a file of its size has");
  EXPECT_EQ(code_, ErrorCode::kBadInput);
}

TEST_F(HostileDump, AMatrixWithoutDataIsNotTaken) {
  EXPECT_EQ(after([&](hid_t f) {
              const Handle list = creation();
              const hsize_t chunk[] = {3, 4096};
              H5Pset_chunk(list.id(), 2, chunk);
              put(f, "/layers/K", list.id(), {3, hsize_t{1} << 40}, H5T_IEEE_F64LE);
            }),
            "/layers/K is missing or malformed");
}

TEST_F(HostileDump, ChunksLargerThanAnyDumpHasAreRefused) {
  const Handle list = creation();
  const hsize_t chunk[] = {65536, 512};
  const hsize_t shape[] = {7, 9}, most[] = {H5S_UNLIMITED, H5S_UNLIMITED};
  H5Pset_chunk(list.id(), 2, chunk);
  EXPECT_EQ(after([&](hid_t f) {
              H5Ldelete(f, "/fluid/depth", H5P_DEFAULT);
              const Handle space(H5Screate_simple(2, shape, most), H5Sclose);
              const Handle made(H5Dcreate2(f, "/fluid/depth", H5T_IEEE_F32LE, space.id(),
                                           H5P_DEFAULT, list.id(), H5P_DEFAULT),
                                H5Dclose);
            }),
            "/fluid/depth has chunks of 134217728 bytes, must be at most 67108864");
}

TEST_F(HostileDump, NamesThatAreManyTimesTheSameBytesAreRefused) {
  // 40000 names of 4 kB each: 160 MB.
  EXPECT_EQ(after([&](hid_t f) {
              H5Ldelete(f, "/palette/name", H5P_DEFAULT);
              const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
              H5Tset_size(type.id(), H5T_VARIABLE);
              const hsize_t count = 40000;
              const Handle space(H5Screate_simple(1, &count, nullptr), H5Sclose);
              const Handle names(H5Dcreate2(f, "/palette/name", type.id(), space.id(), H5P_DEFAULT,
                                            H5P_DEFAULT, H5P_DEFAULT),
                                 H5Dclose);
              const std::string name(4096, 'a');
              const std::vector<const char*> all(count, name.c_str());
              H5Dwrite(names.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, all.data());
            }),
            "/palette/name is missing or malformed");
}

TEST_F(HostileDump, APipeIsNotWaitedFor) {
  const auto dump = read_state(trap_);
  ASSERT_FALSE(dump);
  EXPECT_EQ(dump.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(dump.error().message, trap_ + ": a pipe or a device, must be a file");
}

}  // namespace
}  // namespace pentimento

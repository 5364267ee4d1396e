// What a detail canvas keeps beside its planes, in a dump.

#include <gtest/gtest.h>
#include <hdf5.h>

#include <filesystem>
#include <functional>

#include "formats/hdf5/handle.h"
#include "formats/hdf5/state_dump.h"
#include "tests/formats/hdf5/library_leaks.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"
#include "tests/reference/made_up_canvas.h"

namespace pentimento {
namespace {

using hdf5::Handle;

constexpr int kFactor = 6;  // 36 bits: two words a block

/// A guide of 61 x 47 cells under a canvas 6 times finer, with notes of all kinds.
StateDump noted_dump() {
  StateDump dump = test::made_up_dump(61, 47, 2, 3);
  dump.detail = kFactor;
  CanvasGeometry fine = dump.state.geometry;
  fine.width *= kFactor;
  fine.height *= kFactor;
  dump.fine = std::make_shared<reference::MadeUpCanvas>(fine, 2, dump.state.channels);
  const DetailLayout layout(dump.state.geometry, kFactor);
  DetailCheckpoint checkpoint = make_checkpoint(layout, 2 * dump.state.channels);
  std::mt19937 random(3);
  for (std::uint32_t& value : checkpoint.tile) value = random() % 2;
  for (std::uint32_t& bits : checkpoint.block)  // layers 0 and 1 only
    bits = random() & (1u | 1u << kCheckpointLayerBits | kCheckpointMerges | kCheckpointMismatched |
                       kCheckpointChanged);
  for (std::uint32_t& bits : checkpoint.waiting) bits = random();
  checkpoint.stamped = {{3, 40, {0.6f, -0.8f}, true}, {60, 46, {0, 0}, false}};
  dump.checkpoint = std::move(checkpoint);
  return dump;
}

class CheckpointInADump : public testing::Test {
 private:
  const test::IgnoreLibraryLeaks ignore_;

 protected:
  void SetUp() override { ASSERT_TRUE(write_state(path_, dump_, {})); }

  std::string after(const std::function<void(hid_t)>& change) {
    const std::string copy = scratch_.path("b.h5");
    std::filesystem::copy_file(path_, copy, std::filesystem::copy_options::overwrite_existing);
    {
      const Handle file(H5Fopen(copy.c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose);
      change(file.id());
    }
    const auto dump = read_state(copy);
    if (dump) return dump->checkpoint ? "fine" : "fine without notes";
    EXPECT_EQ(dump.error().code, ErrorCode::kBadInput);
    return dump.error().message.substr(copy.size() + 2);
  }

  /// Sets one value of a dataset of two axes.
  template <typename T>
  static void set(hid_t file, const char* name, hid_t type, hsize_t row, hsize_t column, T value) {
    const Handle dataset(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const hsize_t one = 1, at[2] = {row, column};
    const Handle memory(H5Screate_simple(1, &one, nullptr), H5Sclose);
    const Handle space(H5Dget_space(dataset.id()), H5Sclose);
    H5Sselect_elements(space.id(), H5S_SELECT_SET, 1, at);
    ASSERT_GE(H5Dwrite(dataset.id(), type, memory.id(), space.id(), H5P_DEFAULT, &value), 0);
  }

  const test::Scratch scratch_;
  const std::string path_ = scratch_.path("a.h5");
  const StateDump dump_ = noted_dump();
};

TEST_F(CheckpointInADump, ComeBackAsTheyWere) {
  const auto back = read_state(path_);
  ASSERT_TRUE(back) << back.error().message;
  ASSERT_TRUE(back->checkpoint);
  EXPECT_TRUE(*back->checkpoint == *dump_.checkpoint);
}

TEST_F(CheckpointInADump, MayBeTakenOut) {
  EXPECT_EQ(after([](hid_t f) { H5Ldelete(f, "/detail", H5P_DEFAULT); }), "fine without notes");
}

TEST_F(CheckpointInADump, AreRefusedWithAPartMissing) {
  EXPECT_EQ(after([](hid_t f) { H5Ldelete(f, "/detail/block", H5P_DEFAULT); }),
            "/detail/block is missing or malformed");
  EXPECT_EQ(after([](hid_t f) { H5Ldelete(f, "/detail/left", H5P_DEFAULT); }),
            "/detail/left is missing or malformed");
}

TEST_F(CheckpointInADump, AreRefusedWithALayerOrACellThatThereIsNot) {
  EXPECT_EQ(
      after([](hid_t f) { set<std::uint32_t>(f, "/detail/block", H5T_NATIVE_UINT32, 5, 6, 2u); }),
      "/detail/block names a layer that there is not");
  for (const float bad : {-1.0f, 61.0f, 0.5f, NAN})
    EXPECT_EQ(after([&](hid_t f) { set(f, "/detail/left", H5T_NATIVE_FLOAT, 0, 0, bad); }),
              "/detail/left names a cell that there is not")
        << bad;
}

TEST_F(CheckpointInADump, AreRefusedWithAValueChanged) {
  EXPECT_EQ(after([](hid_t f) {
              set<std::uint32_t>(f, "/detail/tile", H5T_NATIVE_UINT32, 2, 1, 7u);
            }).find("/detail has the hash "),
            0u);
}

}  // namespace
}  // namespace pentimento

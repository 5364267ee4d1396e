#include "formats/hdf5/packed_chunks.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

#include "formats/hdf5/chunked.h"
#include "tests/formats/scratch.h"

namespace pentimento::hdf5 {
namespace {

constexpr hsize_t kPlaneHeight = 6, kPlaneWidth = 10;
constexpr std::array<hsize_t, 2> kPlaneChunk = {4, 4};

/// A plane of 10 by 6 values that count on from 1, but for the second chunk, which is zero.
std::uint32_t value_at(hsize_t x, hsize_t y) {
  return x / 4 == 1 && y / 4 == 0 ? 0
                                  : static_cast<std::uint32_t>(1 + 1000 * (y * kPlaneWidth + x));
}

class PackedPlane : public testing::Test {
 protected:
  void SetUp() override {
    RowSource source;
    source.shape = {kPlaneHeight, kPlaneWidth};
    source.chunk_side = kPlaneChunk[0];
    source.copy = [](std::int64_t row, int x, std::span<std::uint32_t> out) {
      for (std::uint32_t& v : out)
        v = value_at(static_cast<hsize_t>(x++), static_cast<hsize_t>(row));
    };
    written_ =
        Handle(write_chunked(file_.id(), "a", H5T_NATIVE_UINT32, source, 1, Threads(1)), H5Dclose);
    ASSERT_TRUE(written_.ok());
  }

  using Change = void (*)(hid_t list);
  /// A dataset made as write_chunked() makes it, but for `change`.
  Handle made(const char* name, Change change, hid_t type = H5T_STD_U32LE) {
    const std::array<hsize_t, 2> shape = {kPlaneHeight, kPlaneWidth};
    const Handle space(H5Screate_simple(2, shape.data(), nullptr), H5Sclose);
    const Handle list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_chunk(list.id(), 2, kPlaneChunk.data());
    change(list.id());
    return Handle(
        H5Dcreate2(file_.id(), name, type, space.id(), H5P_DEFAULT, list.id(), H5P_DEFAULT),
        H5Dclose);
  }
  static void shuffle_and_deflate(hid_t list) {
    H5Pset_shuffle(list);
    H5Pset_deflate(list, 1);
  }

  const test::Scratch scratch_;
  const Handle file_{
      H5Fcreate(scratch_.path("a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose};
  Handle written_;
};

TEST_F(PackedPlane, GivesWhatTheWriterWrote) {
  const auto chunks = PackedChunks::of(written_.id(), true, kPlaneChunk);
  ASSERT_TRUE(chunks);
  for (hsize_t y = 0; y < kPlaneHeight; y += 4)
    for (hsize_t x = 0; x < kPlaneWidth; x += 4) {
      const std::array<hsize_t, 2> offset = {y, x};
      const auto packed = chunks->fetch(offset);
      ASSERT_TRUE(packed);
      EXPECT_EQ(packed->empty(), x == 4 && y == 0);
      if (packed->empty()) continue;
      std::vector<std::uint32_t> values(16);
      ASSERT_TRUE(unpack_chunk(*packed, values));
      for (hsize_t i = 0; i < 16; ++i) {
        const hsize_t u = x + i % 4, v = y + i / 4;
        EXPECT_EQ(values[i], u < kPlaneWidth && v < kPlaneHeight ? value_at(u, v) : 0)
            << u << ", " << v;
      }
    }
}

TEST_F(PackedPlane, DamagedChunksAreNotUnpacked) {
  const std::array<hsize_t, 2> offset = {0, 0};
  const auto packed = PackedChunks::of(written_.id(), true, kPlaneChunk)->fetch(offset);
  ASSERT_TRUE(packed && !packed->empty());
  std::vector<std::uint32_t> values(16), fewer(15), more(17);
  ASSERT_TRUE(unpack_chunk(*packed, values));
  EXPECT_FALSE(unpack_chunk(*packed, fewer));
  EXPECT_FALSE(unpack_chunk(*packed, more));
  EXPECT_FALSE(unpack_chunk({packed->data(), packed->size() - 1}, values));
  EXPECT_FALSE(unpack_chunk({}, values));
  for (std::size_t i = 0; i < packed->size(); ++i) {
    std::vector<std::uint8_t> changed = *packed;
    changed[i] ^= 0x10;
    // A few bits of the header say nothing about the values.
    std::vector<std::uint32_t> found(16);
    if (!unpack_chunk(changed, found)) continue;
    EXPECT_EQ(found, values) << i;
  }
}

TEST_F(PackedPlane, ChunksOfOtherShapesOrTypesAreNotTaken) {
  const std::array<hsize_t, 2> larger = {4, 8};
  const std::array<hsize_t, 3> of_three = {4, 4, 1};
  EXPECT_FALSE(PackedChunks::of(written_.id(), true, larger));
  EXPECT_FALSE(PackedChunks::of(written_.id(), true, of_three));
  EXPECT_FALSE(PackedChunks::of(written_.id(), false, kPlaneChunk));
  for (const hid_t type : {H5T_STD_U32BE, H5T_STD_U16LE, H5T_IEEE_F64LE})
    EXPECT_FALSE(PackedChunks::of(
        made(std::to_string(type).c_str(), shuffle_and_deflate, type).id(), true, kPlaneChunk));
  EXPECT_TRUE(PackedChunks::of(made("floats", shuffle_and_deflate, H5T_IEEE_F32LE).id(), false,
                               kPlaneChunk));
}

TEST_F(PackedPlane, OtherFiltersAndFillValuesAreNotTaken) {
  const std::pair<const char*, Change> changes[] = {
      {"none", [](hid_t) {}},
      {"deflate alone", [](hid_t list) { H5Pset_deflate(list, 1); }},
      {"the other way round",
       [](hid_t list) {
         H5Pset_deflate(list, 1);
         H5Pset_shuffle(list);
       }},
      {"a checksum too",
       [](hid_t list) {
         shuffle_and_deflate(list);
         H5Pset_fletcher32(list);
       }},
      {"filled with ones", [](hid_t list) {
         constexpr std::uint32_t kOne = 1;
         shuffle_and_deflate(list);
         H5Pset_fill_value(list, H5T_NATIVE_UINT32, &kOne);
       }}};
  for (const auto& [name, change] : changes)
    EXPECT_FALSE(PackedChunks::of(made(name, change).id(), true, kPlaneChunk)) << name;
}

TEST_F(PackedPlane, AChunkThatWasLeftUnpackedIsNotFetched) {
  const Handle dataset = made("unpacked", shuffle_and_deflate);
  const std::array<hsize_t, 2> offset = {0, 0};
  const std::vector<std::uint32_t> values(16, 9);
  constexpr std::uint32_t kNoDeflate = 1u << 1;
  ASSERT_GE(H5Dwrite_chunk(dataset.id(), H5P_DEFAULT, kNoDeflate, offset.data(),
                           values.size() * sizeof(std::uint32_t), values.data()),
            0);
  const auto chunks = PackedChunks::of(dataset.id(), true, kPlaneChunk);
  ASSERT_TRUE(chunks);
  EXPECT_FALSE(chunks->fetch(offset));
}

}  // namespace
}  // namespace pentimento::hdf5

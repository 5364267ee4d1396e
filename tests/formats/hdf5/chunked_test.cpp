#include "formats/hdf5/chunked.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "formats/hdf5/handle.h"
#include "tests/formats/scratch.h"

namespace pentimento::hdf5 {
namespace {

constexpr std::uint64_t kHeight = 7, kWidth = 10;

/// A plane that is no whole number of chunks, 4 by 4: its values count on from 1, row by row.
/// Notes which parts of its rows are asked for: (first cell, cells).
struct CountedPlane {
  RowSource source() {
    RowSource source;
    source.shape = {kHeight, kWidth};
    source.chunk_side = 4;
    source.copy = [this](std::int64_t row, int x, std::span<std::uint32_t> out) {
      for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = 1 + static_cast<std::uint32_t>(row) * kWidth + static_cast<std::uint32_t>(x + i);
      const std::lock_guard guard(mutex);
      asked.insert({x, out.size()});
    };
    return source;
  }

  std::mutex mutex;
  std::set<std::pair<int, std::size_t>> asked;
};

TEST(WriteChunked, ChunksAtTheEdgesAskForCellsOfThePlaneOnly) {
  const test::Scratch scratch;
  CountedPlane plane;
  const Handle file(
      H5Fcreate(scratch.path("a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  ASSERT_TRUE(file.ok());
  const Handle dataset(
      write_chunked(file.id(), "a", H5T_NATIVE_UINT32, plane.source(), 1, Threads(2)), H5Dclose);
  ASSERT_TRUE(dataset.ok());
  // Ten cells in chunks of four: the third chunk has two.
  EXPECT_EQ(plane.asked, (std::set<std::pair<int, std::size_t>>{{0, 4}, {4, 4}, {8, 2}}));
  // HDF5's own reader finds every value in its place.
  std::vector<std::uint32_t> values(kHeight * kWidth);
  ASSERT_GE(H5Dread(dataset.id(), H5T_NATIVE_UINT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()),
            0);
  for (std::size_t i = 0; i < values.size(); ++i) EXPECT_EQ(values[i], i + 1);
}

TEST(WriteChunked, WritesNoMoreOnceItIsCancelled) {
  const test::Scratch scratch;
  CountedPlane plane;
  std::atomic<bool> cancelled = false;
  RowSource source = plane.source();
  source.cancelled = &cancelled;
  source.copy = [&, copy = source.copy](std::int64_t row, int x, std::span<std::uint32_t> out) {
    copy(row, x, out);
    cancelled = true;  // while the first chunk is read
  };
  const Handle file(
      H5Fcreate(scratch.path("a.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  EXPECT_LT(write_chunked(file.id(), "a", H5T_NATIVE_UINT32, source, 1, Threads(1)), 0);
  EXPECT_EQ(plane.asked, (std::set<std::pair<int, std::size_t>>{{0, 4}}));
}

}  // namespace
}  // namespace pentimento::hdf5

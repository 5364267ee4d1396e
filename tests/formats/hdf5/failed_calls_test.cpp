// Dumps of which one call of HDF5 fails, each in turn: one line, nothing half-written, no crash.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>

#include "formats/hdf5/state_dump.h"
#include "tests/formats/hdf5/faulty_hdf5.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"
#include "tests/sanitized.h"

namespace pentimento {
namespace {

using test::FaultyHdf5;

constexpr const char* kWriting[] = {"H5Dcreate2", "H5Dwrite", "H5Dwrite_chunk",
                                    "H5Acreate2", "H5Awrite", "H5Gcreate2"};
constexpr const char* kReading[] = {"H5Gopen2", "H5Dread", "H5Aread", "H5Dget_space",
                                    "H5Dget_type"};

/// A step through so many calls that takes a dozen of them.
int some_of(int calls) {
  return std::max(1, calls * test::kStride / 12);
}

TEST(FailedHdf5, OfWritingLeavesTheOldDump) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a.h5");
  const StateDump dump = test::made_up_dump(9, 7, 2, 3);
  std::map<std::string, int> calls;
  {
    const FaultyHdf5 sound;
    ASSERT_TRUE(write_state(path, dump, {}));
    for (const char* call : kWriting) calls[call] = sound.calls(call);
  }
  test::spill(path, "old");
  int faults = 0;
  for (const char* call : kWriting)
    for (int number = 1; number <= calls[call]; number += test::kStride, ++faults) {
      SCOPED_TRACE(testing::Message() << call << " " << number);
      const FaultyHdf5 faulty(call, number);
      const auto written = write_state(path, dump, {});
      ASSERT_FALSE(written);
      // The dump is built in memory; HDF5 fails when there is none.
      EXPECT_EQ(written.error().code, ErrorCode::kLimit);
      EXPECT_EQ(written.error().message, path + ": no memory to build the state dump");
      EXPECT_EQ(test::slurp(path), "old");
    }
  EXPECT_GT(faults, 50 / test::kStride);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(scratch.path("")), {}), 1);
}

TEST(FailedHdf5, OfReadingIsOneLineInTheTrialAndAfterIt) {
  const test::Scratch scratch;
  const std::string path = scratch.path("a.h5");
  const StateDump dump = test::made_up_dump(9, 7, 2, 3);
  ASSERT_TRUE(write_state(path, dump, {}));
  const std::string whole = test::slurp(path), again = scratch.path("again.h5");
  std::map<std::string, int> calls;
  {
    const FaultyHdf5 sound("", 0, true);
    ASSERT_TRUE(read_state(path));
    for (const char* call : kReading) calls[call] = sound.calls(call);
  }
  int failed = 0;
  for (const char* call : kReading)
    for (int number = 1; number <= calls[call]; number += some_of(calls[call]))
      for (const bool after_trial : {false, true}) {
        SCOPED_TRACE(testing::Message() << call << " " << number << " " << after_trial);
        const auto read = [&] {
          const FaultyHdf5 faulty(call, number, after_trial);
          return read_state(path);
        }();
        // What was read is all that was written: not the values alone, whose hash is compared
        // anyway.
        if (read) {
          ASSERT_TRUE(write_state(again, *read, {}));
          EXPECT_TRUE(test::slurp(again) == whole);
          continue;
        }
        ++failed;
        EXPECT_EQ(read.error().message.find("have the hash"), std::string::npos)
            << read.error().message;
        EXPECT_TRUE(read.error().message.starts_with(path + ": ")) << read.error().message;
        EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
      }
  EXPECT_GT(failed, 20 / test::kStride);
}

}  // namespace
}  // namespace pentimento

#include "replay/checkpoint/disk_probe.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "tests/formats/faulty_disk.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::FaultyDisk;
using test::Scratch;

TEST(DiskProbe, ReachesTheDiskAndLeavesNothing) {
  const Scratch scratch;
  FaultyDisk disk;
  const Result<double> taken_s = time_of_writing_s(scratch.path("1.slot.part"), 3);
  ASSERT_TRUE(taken_s) << taken_s.error().message;
  EXPECT_GT(*taken_s, 0);
  EXPECT_EQ(disk.noted, std::vector<std::string>{"fsync " + scratch.path("1.slot.part")});
  EXPECT_EQ(disk.calls("write"), 3) << "of 1 MiB each";
  EXPECT_EQ(scratch.files(), 0u);
}

TEST(DiskProbe, OfAFullDiskIsAnErrorAndLeavesNothing) {
  const Scratch scratch;
  EXPECT_EQ(time_of_writing_s(scratch.path("none/1"), 1).error().code, ErrorCode::kIo);
  for (const char* call : {"write", "fsync"}) {
    FaultyDisk disk;
    disk.always(call, ENOSPC);
    const Result<double> taken_s = time_of_writing_s(scratch.path("1"), 1);
    ASSERT_FALSE(taken_s);
    EXPECT_EQ(taken_s.error().message, scratch.path("1") + ": No space left on device");
    EXPECT_EQ(scratch.files(), 0u);
  }
}

}  // namespace
}  // namespace pentimento

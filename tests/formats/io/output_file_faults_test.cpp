// Calls of the machine that fail, or do less than asked, while an output is written, read back and
// named: each has one of three ends. The file is whole, or it keeps its old bytes and a line says
// why, or its name was given and a line says that the folder may not know it yet.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "formats/io/output_file.h"
#include "formats/io/publish.h"
#include "tests/formats/faulty_disk.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::FaultyDisk;
using test::Scratch;
using test::slurp;
using test::spill;

/// What publishing "new bytes" over "old" says: nothing if it went well.
std::string said(const Scratch& scratch) {
  const auto published = publish_bytes(scratch.path("a.bin"), "new bytes");
  return published ? "" : published.error().message;
}

/// A fault of one call that a run survives.
void expect_survived(const std::string& call, test::Fault fault, int calls) {
  SCOPED_TRACE(call);
  const Scratch scratch;
  spill(scratch.path("a.bin"), "old");
  FaultyDisk disk;
  disk.plan(call, 1, fault);
  EXPECT_EQ(said(scratch), "");
  EXPECT_EQ(disk.calls(call), calls);
  EXPECT_EQ(slurp(scratch.path("a.bin")), "new bytes");
  EXPECT_EQ(scratch.files(), 1u);
}

/// A fault of the `number`-th call after which the old file is there, and no other.
void expect_refused(const std::string& call, int number, test::Fault fault,
                    const std::string& reason) {
  SCOPED_TRACE(call);
  const Scratch scratch;
  spill(scratch.path("a.bin"), "old");
  FaultyDisk disk;
  disk.plan(call, number, fault);
  EXPECT_EQ(said(scratch), scratch.path("a.bin") + ": " + reason);
  EXPECT_EQ(slurp(scratch.path("a.bin")), "old");
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(OutputFileFaults, WhatWasInterruptedOrCutShortGoesOn) {
  expect_survived("write", {EINTR}, 2);
  expect_survived("write", {0, 4}, 2);
  expect_survived("read", {EINTR}, 3);  // the bytes, and the end
  expect_survived("read", {0, 4}, 3);
}

TEST(OutputFileFaults, WhatTheMachineRefusesLeavesTheOldFile) {
  expect_refused("write", 1, {ENOSPC}, "No space left on device");
  expect_refused("write", 1, {0, 0}, "Input/output error");
  expect_refused("fsync", 1, {EIO}, "Input/output error");
  expect_refused("lseek", 1, {EIO}, "Input/output error");
  expect_refused("read", 1, {EIO}, "Input/output error");
  expect_refused("rename", 1, {EACCES}, "Permission denied");
}

TEST(OutputFileFaults, ADiskThatGivesBackOtherBytesIsFoundOut) {
  expect_refused("read", 1, {0, ~0UL, true}, "what was read back differs from what was written");
}

TEST(OutputFileFaults, AFolderThatIsNotSyncedIsToldButForOneThatCannotBe) {
  for (const int error_number : {EIO, EINVAL}) {
    const Scratch scratch;
    FaultyDisk disk;
    disk.plan("fsync", 2, {error_number});
    EXPECT_EQ(said(scratch),
              error_number == EIO ? scratch.path("a.bin") + ": Input/output error" : "");
    EXPECT_EQ(slurp(scratch.path("a.bin")), "new bytes") << "it had its name before";
    EXPECT_EQ(scratch.files(), 1u);
  }
}

TEST(OutputFileFaults, AnAddressThatCannotBeReachedFailsTheFile) {
  const Scratch scratch;
  FaultyDisk disk;
  auto file = OutputFile::create(scratch.path("a.bin"), false);
  ASSERT_TRUE(file);
  (*file)->write("hello", 5);
  disk.plan("lseek", 1, {ESPIPE});
  (*file)->seek(1);
  (*file)->write("u", 1);
  EXPECT_EQ((*file)->status().error().message, scratch.path("a.bin") + ": Illegal seek");
  EXPECT_FALSE((*file)->publish());
  file->reset();
  EXPECT_EQ(scratch.files(), 0u);
}

TEST(OutputFileFaults, ReadsWhatItWrote_OrFails) {
  const Scratch scratch;
  FaultyDisk disk;
  auto file = OutputFile::create(scratch.path("a.bin"), false);
  ASSERT_TRUE(file);
  (*file)->write("hello", 5);
  std::string bytes(3, ' ');
  disk.plan("pread", 1, {EINTR});
  disk.plan("pread", 2, {0, 1});
  (*file)->read_at(1, bytes.data(), bytes.size());
  EXPECT_EQ(bytes, "ell");
  EXPECT_EQ(disk.calls("pread"), 3);
  std::string beyond(4, '.');
  (*file)->read_at(3, beyond.data(), beyond.size());
  EXPECT_EQ(beyond, "lo..") << "what is not there is left as it was";
  EXPECT_TRUE((*file)->status());
  disk.plan("pread", 1, {EIO});
  (*file)->read_at(0, bytes.data(), bytes.size());
  EXPECT_EQ((*file)->status().error().message, scratch.path("a.bin") + ": Input/output error");
}

TEST(OutputFileFaults, APipeTakesTheBytesAndStaysAPipe) {
  const Scratch scratch;
  const std::string path = scratch.path("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  const int reader = ::open(path.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_TRUE(publish_bytes(path, "hello"));
  std::string bytes(5, ' ');
  EXPECT_EQ(::read(reader, bytes.data(), bytes.size()), 5);
  EXPECT_EQ(bytes, "hello");
  EXPECT_TRUE(std::filesystem::is_fifo(path));
  FaultyDisk disk;
  disk.plan("write", 1, {EINTR});
  const auto interrupted = publish_bytes(path, "more");
  ASSERT_FALSE(interrupted) << "its reader may never go on, so a signal must end it";
  EXPECT_EQ(interrupted.error().code, ErrorCode::kInterrupted);
  EXPECT_EQ(interrupted.error().message, path + ": interrupted");
  ::close(reader);
}

TEST(OutputFileFaults, APipeThatNobodyReadsIsWaitedForTenSeconds) {
  const Scratch scratch;
  const std::string path = scratch.path("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  FaultyDisk disk;
  const auto alone = OutputFile::create(path, false);
  ASSERT_FALSE(alone);
  EXPECT_EQ(alone.error().message, path + ": nobody reads this pipe");
  EXPECT_EQ(disk.calls("nanosleep"), 200) << "of 50 ms each";
  disk.plan("nanosleep", 3, {EINTR});
  const auto interrupted = OutputFile::create(path, false);
  ASSERT_FALSE(interrupted);
  EXPECT_EQ(interrupted.error().code, ErrorCode::kInterrupted);
}

TEST(OutputFileFaults, ALinkToALinkThatEndsNowhereMakesItsTarget) {
  const Scratch scratch;
  std::filesystem::create_symlink("b.bin", scratch.path("a.bin"));
  std::filesystem::create_symlink("c.bin", scratch.path("b.bin"));
  EXPECT_EQ(said(scratch), "");
  EXPECT_EQ(slurp(scratch.path("c.bin")), "new bytes");
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("b.bin")));
}

}  // namespace
}  // namespace pentimento

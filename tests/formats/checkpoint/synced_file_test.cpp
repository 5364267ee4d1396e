#include "formats/checkpoint/synced_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cerrno>
#include <csignal>

#include "tests/formats/faulty_disk.h"
#include "tests/formats/scratch.h"

namespace pentimento::checkpoint {
namespace {

using test::FaultyDisk;
using test::Scratch;
using test::slurp;
using test::spill;

TEST(SyncedFile, GoesOnWhereItIsToldAndCutsOffTheRest) {
  const Scratch scratch;
  const std::string path = scratch.path("a");
  spill(path, "kept, and torn");
  const auto file = SyncedFile::go_on(path, 4);
  ASSERT_TRUE(file) << file.error().message;
  (*file)->write(" on");
  ASSERT_TRUE((*file)->sync());
  EXPECT_EQ(slurp(path), "kept on");
  EXPECT_EQ((*file)->size(), 7u);
  const auto shorter = SyncedFile::go_on(path, 8);
  ASSERT_FALSE(shorter);
  EXPECT_EQ(shorter.error().code, ErrorCode::kBadInput);
}

TEST(SyncedFile, ANewFileDoesNotFollowALink) {
  const Scratch scratch;
  spill(scratch.path("target"), "precious");
  std::filesystem::create_symlink(scratch.path("target"), scratch.path("a"));
  const auto file = SyncedFile::create(scratch.path("a"));
  ASSERT_TRUE(file);
  (*file)->write("new");
  ASSERT_TRUE((*file)->sync());
  EXPECT_EQ(slurp(scratch.path("target")), "precious");
  EXPECT_EQ(slurp(scratch.path("a")), "new");
}

TEST(SyncedFile, TheFirstFailureStays) {
  const Scratch scratch;
  const auto file = SyncedFile::create(scratch.path("a"));
  ASSERT_TRUE(file);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{4, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  (*file)->write("more than four");
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  (*file)->write("x");
  const Result<void> synced = (*file)->sync();
  ASSERT_FALSE(synced);
  EXPECT_EQ(synced.error().code, ErrorCode::kIo);
}

TEST(SyncedFile, ReadsOnlyWhatIsThere) {
  const Scratch scratch;
  spill(scratch.path("a"), "0123456789");
  const auto file = PlacedReader::open(scratch.path("a"));
  ASSERT_TRUE(file);
  std::string out(3, ' ');
  ASSERT_TRUE((*file)->read(7, out));
  EXPECT_EQ(out, "789");
  EXPECT_FALSE((*file)->read(8, out));
  EXPECT_FALSE((*file)->read(~std::uint64_t{0}, out)) << "the sum wraps around";
}

TEST(SyncedFile, RenamesAndLinks) {
  const Scratch scratch;
  spill(scratch.path("a"), "bytes");
  ASSERT_TRUE(link_or_copy(scratch.path("a"), scratch.path("b")));
  ASSERT_TRUE(rename_synced(scratch.path("a"), scratch.path("c")));
  EXPECT_EQ(slurp(scratch.path("b")), "bytes");
  EXPECT_EQ(slurp(scratch.path("c")), "bytes");
  EXPECT_FALSE(rename_synced(scratch.path("a"), scratch.path("d")));
}

TEST(SyncedFile, WhatWasInterruptedOrCutShortGoesOn) {
  const Scratch scratch;
  FaultyDisk disk;
  disk.plan("write", 1, {EINTR});
  disk.plan("write", 2, {0, 3});
  const auto file = SyncedFile::create(scratch.path("a"));
  ASSERT_TRUE(file);
  (*file)->write("bytes");
  ASSERT_TRUE((*file)->sync());
  EXPECT_EQ(disk.calls("write"), 3);
  EXPECT_EQ(slurp(scratch.path("a")), "bytes");
  disk.plan("pread", 1, {EINTR});
  disk.plan("pread", 2, {0, 2});
  const auto reader = PlacedReader::open(scratch.path("a"));
  ASSERT_TRUE(reader);
  std::string out(5, ' ');
  ASSERT_TRUE((*reader)->read(0, out));
  EXPECT_EQ(out, "bytes");
  EXPECT_EQ(disk.calls("pread"), 3);
}

TEST(SyncedFile, ADiskThatTakesNothingIsAnError) {
  const Scratch scratch;
  FaultyDisk disk;
  disk.plan("write", 1, {0, 0});
  const auto file = SyncedFile::create(scratch.path("a"));
  ASSERT_TRUE(file);
  (*file)->write("bytes");
  EXPECT_EQ((*file)->sync().error().message, scratch.path("a") + ": Input/output error");
}

TEST(SyncedFile, AFailedSyncIsFinal) {
  const Scratch scratch;
  FaultyDisk disk;
  const auto file = SyncedFile::create(scratch.path("a"));
  ASSERT_TRUE(file);
  (*file)->write("bytes");
  disk.plan("fsync", 1, {EIO});
  EXPECT_FALSE((*file)->sync());
  EXPECT_FALSE((*file)->sync()) << "the kernel may have dropped what it could not write";
  EXPECT_EQ(disk.calls("fsync"), 1);
}

TEST(SyncedFile, SaysWhyItCannotGoOn) {
  const Scratch scratch;
  const std::string path = scratch.path("a");
  EXPECT_EQ(SyncedFile::go_on(path, 0).error().message, path + ": No such file or directory");
  EXPECT_EQ(SyncedFile::create(scratch.path("none/a")).error().message,
            scratch.path("none/a") + ": No such file or directory");
  spill(path, "bytes");
  for (const char* call : {"ftruncate", "lseek"}) {
    FaultyDisk disk;
    disk.plan(call, 1, {EIO});
    EXPECT_EQ(SyncedFile::go_on(path, 4).error().message, path + ": Input/output error");
  }
}

TEST(SyncedFile, ReadsFilesOnlyAndTellsWhatFails) {
  const Scratch scratch;
  ASSERT_EQ(::mkfifo(scratch.path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(PlacedReader::open(scratch.path("pipe")).error().message,
            scratch.path("pipe") + ": it is no file");
  EXPECT_EQ(PlacedReader::open(scratch.path("none")).error().code, ErrorCode::kIo);
  spill(scratch.path("a"), "bytes");
  const auto file = PlacedReader::open(scratch.path("a"));
  ASSERT_TRUE(file);
  std::string out(5, ' ');
  FaultyDisk disk;
  disk.plan("pread", 1, {EIO});
  EXPECT_EQ((*file)->read(0, out).error().code, ErrorCode::kIo);
  std::filesystem::resize_file(scratch.path("a"), 2);
  const Result<void> cut = (*file)->read(0, out);
  ASSERT_FALSE(cut) << "it was cut after it had been opened";
  EXPECT_EQ(cut.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(cut.error().message, scratch.path("a") + ": it ends too early");
}

TEST(SyncedFile, AFolderThatIsNotSyncedIsToldButForOneThatCannotBe) {
  const Scratch scratch;
  FaultyDisk disk;
  disk.plan("fsync", 1, {EIO});
  EXPECT_EQ(sync_folder(scratch.path("")).error().message,
            scratch.path("") + ": Input/output error");
  disk.plan("fsync", 1, {EINVAL});
  EXPECT_TRUE(sync_folder(scratch.path("")));
  EXPECT_EQ(sync_folder(scratch.path("none")).error().code, ErrorCode::kIo);
}

TEST(SyncedFile, IsCopiedWhereTheFileSystemHasNoSecondNames) {
  const Scratch scratch;
  const std::string bytes((1 << 20) + 7, 'x');
  spill(scratch.path("a"), bytes);
  FaultyDisk disk;
  disk.always("link", EPERM);
  ASSERT_TRUE(link_or_copy(scratch.path("a"), scratch.path("b")));
  EXPECT_TRUE(slurp(scratch.path("b")) == bytes);
  EXPECT_EQ(std::filesystem::hard_link_count(scratch.path("a")), 1u);
  EXPECT_EQ(disk.calls("fsync"), 1) << "a copy must reach the disk";
  EXPECT_FALSE(link_or_copy(scratch.path("none"), scratch.path("c")));
  EXPECT_FALSE(link_or_copy(scratch.path("a"), scratch.path("none/c")));
  disk.plan("pread", 2, {EIO});
  EXPECT_FALSE(link_or_copy(scratch.path("a"), scratch.path("c")));
  disk.plan("write", 1, {ENOSPC});
  EXPECT_FALSE(link_or_copy(scratch.path("a"), scratch.path("c")));
}

}  // namespace
}  // namespace pentimento::checkpoint

#include "formats/io/output_file.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "formats/io/publish.h"
#include "tests/formats/faulty_disk.h"
#include "tests/formats/io/small_files.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;
using test::slurp;
using test::SmallFiles;
using test::spill;

TEST(OutputFile, IsOnTheDiskBeforeItHasItsNameAndThenTheNameIsToo) {
  for (const bool no_clobber : {false, true}) {
    const Scratch scratch;
    const std::string path = scratch.path("a.bin");
    std::string temporary;
    test::FaultyDisk disk;
    auto file = OutputFile::create(path, no_clobber);
    ASSERT_TRUE(file);
    (*file)->write("hello", 5);
    ASSERT_TRUE((*file)->publish([&](const std::string& name) -> Result<void> {
      temporary = name;
      return {};
    }));
    const std::string folder = std::filesystem::path(path).parent_path().string();
    EXPECT_EQ(disk.noted,
              (std::vector<std::string>{"fsync " + temporary, "name " + temporary + " " + path,
                                        "fsync " + folder}));
  }
}

TEST(OutputFile, WhatTheDiskDidNotTakeGetsNoName) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  spill(path, "old");
  test::FaultyDisk disk;
  disk.always("fsync", EIO);
  const auto published = publish_bytes(path, "new");
  ASSERT_FALSE(published);
  EXPECT_EQ(published.error().message, path + ": Input/output error");
  EXPECT_EQ(slurp(path), "old");
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(OutputFile, AppearsOnlyWhenPublished) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  auto file = OutputFile::create(path, false);
  ASSERT_TRUE(file);
  (*file)->write("hello", 5);
  EXPECT_FALSE(std::filesystem::exists(path));
  const auto published = (*file)->publish();
  ASSERT_TRUE(published);
  EXPECT_EQ(slurp(path), "hello");
  // echo -n hello | sha256sum
  EXPECT_EQ(published->sha256, "2cf24dba5fb0a30e26e83b2ac5b9e29e1b161e5c1fa7425e73043362938b9824");
  EXPECT_EQ(published->file, path);
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(OutputFile, LeavesNothingWhenAbandoned) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  spill(path, "old");
  {
    auto file = OutputFile::create(path, false);
    ASSERT_TRUE(file);
    (*file)->write("new", 3);
  }
  EXPECT_EQ(slurp(path), "old");
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(OutputFile, SeeksBackAndHashesTheResult) {
  const Scratch scratch;
  auto file = OutputFile::create(scratch.path("a.bin"), false);
  ASSERT_TRUE(file);
  (*file)->write("xxllo", 5);
  (*file)->seek(0);
  (*file)->write("he", 2);
  EXPECT_EQ((*file)->position(), 2u);
  const auto published = (*file)->publish();
  ASSERT_TRUE(published);
  EXPECT_EQ(slurp(scratch.path("a.bin")), "hello");
  EXPECT_EQ(published->sha256, "2cf24dba5fb0a30e26e83b2ac5b9e29e1b161e5c1fa7425e73043362938b9824");
}

TEST(OutputFile, RejectsWhatTheCheckRejects) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  spill(path, "old");
  auto file = OutputFile::create(path, false);
  ASSERT_TRUE(file);
  (*file)->write("new", 3);
  const auto published = (*file)->publish([](const std::string& temporary) -> Result<void> {
    EXPECT_EQ(slurp(temporary), "new");
    return Error{ErrorCode::kIo, "not good"};
  });
  ASSERT_FALSE(published);
  file->reset();
  EXPECT_EQ(slurp(path), "old");
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(OutputFile, NamesTargetAndReasonInOneLine) {
  const Scratch scratch;
  const auto folder = publish_bytes(scratch.path(""), "x");
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().code, ErrorCode::kIo);
  EXPECT_EQ(folder.error().message, scratch.path("") + ": Is a directory");
  const auto no_parent = publish_bytes(scratch.path("none/a.bin"), "x");
  ASSERT_FALSE(no_parent);
  EXPECT_EQ(no_parent.error().message, scratch.path("none/a.bin") + ": No such file or directory");
}

TEST(OutputFile, NoClobberKeepsTheOldFile) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  ASSERT_TRUE(publish_bytes(path, "one", true));
  const auto second = publish_bytes(path, "two", true);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message, path + ": File exists");
  EXPECT_EQ(slurp(path), "one");
}

TEST(OutputFile, NoClobberRefusesAnOldFileBeforeAnythingIsComputed) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  spill(path, "old");
  const auto file = OutputFile::create(path, true);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().message, path + ": File exists");
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(OutputFile, NoClobberKeepsAFileThatAppearsMeanwhile) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  {
    auto file = OutputFile::create(path, true);
    ASSERT_TRUE(file);
    spill(path, "other");
    EXPECT_FALSE((*file)->publish());
  }
  EXPECT_EQ(slurp(path), "other");
  EXPECT_EQ(scratch.files(), 1u);
}

TEST(OutputFile, FollowsALinkAndKeepsIt) {
  const Scratch scratch;
  spill(scratch.path("real.bin"), "old");
  std::filesystem::create_symlink("real.bin", scratch.path("link.bin"));
  ASSERT_TRUE(publish_bytes(scratch.path("link.bin"), "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(scratch.path("link.bin")));
  EXPECT_EQ(slurp(scratch.path("real.bin")), "new");
}

TEST(OutputFile, AFullDeviceIsAnError) {
  const auto published = publish_bytes("/dev/full", "x");
  ASSERT_FALSE(published);
  EXPECT_EQ(published.error().message, "/dev/full: No space left on device");
}

TEST(OutputFile, TheFirstFailedWriteSticks) {
  const Scratch scratch;
  const std::string path = scratch.path("a.bin");
  spill(path, "old");
  {
    const SmallFiles limit(1 << 20);
    auto file = OutputFile::create(path, false);
    ASSERT_TRUE(file);
    const std::string megabyte(1 << 20, 'x');
    for (int i = 0; i < 4; ++i) (*file)->write(megabyte.data(), megabyte.size());
    EXPECT_TRUE((*file)->failed());
    EXPECT_FALSE((*file)->status());
    const auto published = (*file)->publish();
    ASSERT_FALSE(published);
    EXPECT_EQ(published.error().message, path + ": File too large");
  }
  EXPECT_EQ(slurp(path), "old");
  EXPECT_EQ(scratch.files(), 1u);
}

}  // namespace
}  // namespace pentimento

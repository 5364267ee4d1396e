#include "formats/checkpoint/synced_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "tests/formats/scratch.h"

namespace pentimento::checkpoint {
namespace {

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

}  // namespace
}  // namespace pentimento::checkpoint

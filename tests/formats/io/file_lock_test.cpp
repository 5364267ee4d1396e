#include "formats/io/file_lock.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <thread>
#include <vector>

#include "tests/formats/faulty_disk.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(FileLock, IsHeldByOneAndGoesWithIt) {
  const test::Scratch scratch;
  {
    Result<std::unique_ptr<FileLock>> first = FileLock::take(scratch.path("picture.png"));
    ASSERT_TRUE(first.ok());
    const Result<std::unique_ptr<FileLock>> second = FileLock::take(scratch.path("picture.png"));
    ASSERT_FALSE(second.ok());
    EXPECT_EQ(second.error().code, ErrorCode::kUsage);
    EXPECT_EQ(second.error().message,
              "-o " + scratch.path("picture.png") + ": another run is writing it");
    EXPECT_TRUE(FileLock::take(scratch.path("other.png")).ok());
    EXPECT_EQ(scratch.files(), 1U) << "the lock of other.png has gone";
  }
  EXPECT_EQ(scratch.files(), 0U);
  EXPECT_TRUE(FileLock::take(scratch.path("picture.png")).ok());
}

TEST(FileLock, OfALinkIsThatOfItsTarget) {
  const test::Scratch scratch;
  std::filesystem::create_symlink("picture.png", scratch.path("link.png"));
  const auto held = FileLock::take(scratch.path("link.png"));
  ASSERT_TRUE(held.ok());
  EXPECT_FALSE(FileLock::take(scratch.path("picture.png")).ok());
}

TEST(FileLock, OfAKilledProcessBlocksNobody) {
  const test::Scratch scratch;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const auto held = FileLock::take(scratch.path("picture.png"));
    if (::write(ready[1], "x", 1) == 1) ::pause();
    ::_exit(held.ok() ? 0 : 1);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_FALSE(FileLock::take(scratch.path("picture.png")).ok());
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  EXPECT_EQ(scratch.files(), 1U) << "the dead process's";
  const auto other = FileLock::take(scratch.path("other.png"));
  FileLock::remove_stale(scratch.path(""));
  EXPECT_EQ(scratch.files(), 1U) << "the lock of other.png, which is held";
  EXPECT_FALSE(FileLock::take(scratch.path("other.png")).ok());
  EXPECT_TRUE(FileLock::take(scratch.path("picture.png")).ok());
  ::close(ready[0]);
  ::close(ready[1]);
}

/// Each thread opens the lock's file anew, so to the kernel they are strangers, as processes are.
TEST(FileLock, IsNeverHeldByTwoHoweverTheyCome) {
  const test::Scratch scratch;
  std::atomic<int> holders{0}, most{0}, taken{0};
  const auto compete = [&] {
    for (int i = 0; i < 500; ++i) {
      const auto held = FileLock::take(scratch.path("picture.png"));
      if (!held.ok()) continue;
      const int now = ++holders;
      int before = most;
      while (now > before && !most.compare_exchange_weak(before, now)) {
      }
      ++taken;
      --holders;
    }
  };
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) threads.emplace_back(compete);
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
  EXPECT_GT(taken, 0);
}

TEST(FileLock, NeedsAFolder) {
  const auto lock = FileLock::take("/no/such/folder/picture.png");
  ASSERT_FALSE(lock.ok());
  EXPECT_EQ(lock.error().code, ErrorCode::kIo);
  EXPECT_EQ(lock.error().message, "/no/such/folder/picture.png: No such file or directory");
}

TEST(FileLock, IsAskedForAgainAfterASignal) {
  const test::Scratch scratch;
  test::FaultyDisk disk;
  disk.plan("flock", 1, {EINTR});
  const auto held = FileLock::take(scratch.path("picture.png"));
  ASSERT_TRUE(held.ok());
  EXPECT_NE(*held, nullptr);
  EXPECT_EQ(disk.calls("flock"), 2);
}

TEST(FileLock, IsDoneWithoutWhereTheFileSystemHasNone) {
  const test::Scratch scratch;
  for (const int error_number : {ENOLCK, EOPNOTSUPP}) {
    test::FaultyDisk disk;
    disk.always("flock", error_number);
    const auto none = FileLock::take(scratch.path("picture.png"));
    ASSERT_TRUE(none.ok());
    EXPECT_EQ(*none, nullptr);
  }
}

TEST(FileLock, ThatFailsOtherwiseIsAnError) {
  const test::Scratch scratch;
  test::FaultyDisk disk;
  disk.always("flock", EIO);
  const auto lock = FileLock::take(scratch.path("picture.png"));
  ASSERT_FALSE(lock.ok());
  EXPECT_EQ(lock.error().message, scratch.path("picture.png") + ": Input/output error");
}

TEST(FileLock, RemovesNoFileThatIsNoLock) {
  const test::Scratch scratch;
  test::spill(scratch.path("target"), "precious");
  std::filesystem::create_symlink("target", scratch.path(".pentimento-0123456789abcdef.lock"));
  for (const char* name : {"notes.lock", ".pentimento-notes", ".pentimento-0123456789abcdee.lock"})
    test::spill(scratch.path(name), "x");
  FileLock::remove_stale(scratch.path(""));
  EXPECT_EQ(scratch.files(), 4U) << "the last of them was a lock that nobody holds";
  EXPECT_EQ(test::slurp(scratch.path("target")), "precious");
  FileLock::remove_stale(scratch.path("no such folder"));
}

}  // namespace
}  // namespace pentimento

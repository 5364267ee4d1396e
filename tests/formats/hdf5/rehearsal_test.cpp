#include "formats/hdf5/rehearsal.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

namespace pentimento::hdf5 {
namespace {

using namespace std::chrono_literals;

Result<void> sleep_long(const Rehearsal&) {
  std::this_thread::sleep_for(600s);
  return {};
}

TEST(Rehearse, ACrashIsAnErrorThatNamesTheFile) {
  const Result<void> done = rehearse("a.h5", nullptr, [](const Rehearsal&) -> Result<void> {
    std::raise(SIGKILL);
    return {};
  });
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(done.error().message, "a.h5: a damaged HDF5 file");
}

TEST(Rehearse, WhatTheChildDoesStaysThere) {
  int changed = 0;
  EXPECT_TRUE(rehearse("a.h5", nullptr, [&](const Rehearsal&) -> Result<void> {
    ++changed;
    return {};
  }));
  EXPECT_EQ(changed, 0);
}

TEST(Rehearse, TheChildsErrorComesOut) {
  const std::string long_text(3000, 'x');
  const Result<void> done = rehearse("a.h5", nullptr, [&](const Rehearsal& from) -> Result<void> {
    from.expect(1000, 0);
    return Error{ErrorCode::kLimit, long_text};
  });
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, ErrorCode::kLimit);
  EXPECT_EQ(done.error().message, long_text);
}

TEST(Rehearse, AnExceptionIsAnError) {
  const Result<void> done =
      rehearse("a.h5", nullptr, [](const Rehearsal&) -> Result<void> { throw std::bad_alloc(); });
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().message, "a.h5: no memory to read it");
}

TEST(Rehearse, AChildThatTakesTooLongIsKilled) {
  RehearsalLimits limits;
  limits.seconds = 0.2;
  const Result<void> done = rehearse("a.h5", nullptr, sleep_long, limits);
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, ErrorCode::kBadInput);
  EXPECT_EQ(done.error().message, "a.h5: not read within 0 s: damaged, or made to take long");
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  EXPECT_EQ(errno, ECHILD);
}

TEST(Rehearse, WhatIsExpectedExtendsTheTime) {
  RehearsalLimits limits;
  limits.seconds = 0.1;
  limits.bytes_per_second = 1;
  const auto half_a_second = [](const Rehearsal& rehearsal) -> Result<void> {
    rehearsal.expect(600, 0);
    std::this_thread::sleep_for(500ms);
    return {};
  };
  EXPECT_TRUE(rehearse("a.h5", nullptr, half_a_second, limits));
}

TEST(Rehearse, ASignalEndsTheWaiting) {
  std::atomic<bool> cancelled{false};
  std::thread later([&] {
    std::this_thread::sleep_for(100ms);
    cancelled = true;
  });
  const Result<void> done = rehearse("a.h5", &cancelled, sleep_long);
  later.join();
  ASSERT_FALSE(done.ok());
  EXPECT_EQ(done.error().code, ErrorCode::kInterrupted);
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
}

TEST(Rehearse, TheChildEndsWithItsParent) {
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  // A parent that is killed while its child reads.
  const pid_t parent = fork();
  if (parent == 0) {
    close(ends[0]);
    (void)rehearse("a.h5", nullptr, sleep_long);
    _exit(0);
  }
  close(ends[1]);
  std::this_thread::sleep_for(200ms);
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  // Both had the writing end: the pipe ends when neither lives.
  char byte = 0;
  EXPECT_EQ(::read(ends[0], &byte, 1), 0);
  close(ends[0]);
}

#ifndef PENTIMENTO_SANITIZED
TEST(Rehearse, AChildThatTakesTooMuchMemoryIsRefused) {
  RehearsalLimits limits;
  limits.bytes = 64 << 20;
  const auto take = [](std::size_t bytes, const Rehearsal& rehearsal, std::uint64_t expected) {
    rehearsal.expect(0, expected);
    const auto memory = std::make_unique<char[]>(bytes);
    return memory[bytes / 2] == 0 ? Result<void>() : Error{ErrorCode::kBadInput, "?"};
  };
  EXPECT_TRUE(rehearse(
      "a.h5", nullptr, [&](const Rehearsal& r) { return take(16 << 20, r, 0); }, limits));
  const Result<void> much = rehearse(
      "a.h5", nullptr, [&](const Rehearsal& r) { return take(256 << 20, r, 0); }, limits);
  ASSERT_FALSE(much.ok());
  EXPECT_EQ(much.error().code, ErrorCode::kLimit);
  EXPECT_TRUE(rehearse(
      "a.h5", nullptr, [&](const Rehearsal& r) { return take(256 << 20, r, 300 << 20); }, limits));
}
#endif

}  // namespace
}  // namespace pentimento::hdf5

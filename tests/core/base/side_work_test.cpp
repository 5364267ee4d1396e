#include "core/base/side_work.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

namespace pentimento {
namespace {

TEST(SideWork, GoesOnBesideItsCaller) {
  std::promise<void> go;
  std::thread::id worker;
  SideWork work;
  // The work ends only after its caller has gone on.
  work.begin([&] {
    go.get_future().wait();
    worker = std::this_thread::get_id();
  });
  go.set_value();
  work.wait();
  EXPECT_NE(worker, std::thread::id());
  EXPECT_NE(worker, std::this_thread::get_id());
}

TEST(SideWork, PiecesFollowOneAnother) {
  SideWork work;
  int done = 0;  // no atomic: only one piece at a time touches it
  for (int i = 0; i < 500; ++i)
    work.begin([&, i] {
      if (done == i) ++done;
    });
  work.wait();
  EXPECT_EQ(done, 500);
}

TEST(SideWork, WhatItThrowsReachesTheCallerOnce) {
  SideWork work;
  work.begin([] { throw std::runtime_error("no"); });
  EXPECT_THROW(work.wait(), std::runtime_error);
  EXPECT_NO_THROW(work.wait());
  work.begin([] { throw std::runtime_error("no"); });
  EXPECT_THROW(work.begin([] {}), std::runtime_error);
}

TEST(SideWork, EndsBeforeItIsGone) {
  std::atomic<bool> done{false};
  {
    SideWork work;
    work.begin([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      done = true;
    });
  }
  EXPECT_TRUE(done);
}

// In a process of its own, which may have no more memory: there is no stack for another thread.
TEST(SideWork, WithoutAThreadTheCallerDoesIt) {
#if defined(PENTIMENTO_SANITIZED)
  GTEST_SKIP() << "a sanitizer needs memory of its own";
#endif
  const pid_t child = fork();
  if (child == 0) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_AS, &none);
    // Stacks of threads that have ended are used again, so some threads are there yet.
    std::array<SideWork, 64> works;
    std::atomic<bool> by_caller{false};
    const auto caller = std::this_thread::get_id();
    for (std::size_t i = 0; i < works.size() && !by_caller; ++i)
      works[i].begin([&] {
        if (std::this_thread::get_id() == caller) by_caller = true;
        while (!by_caller) std::this_thread::yield();
      });
    _exit(by_caller ? 7 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

}  // namespace
}  // namespace pentimento

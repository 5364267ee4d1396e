#include "core/base/worker_pool.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

namespace pentimento {
namespace {

TEST(WorkerPool, CoversEveryIndexOnce) {
  WorkerPool pool(3);
  for (int round = 0; round < 2000; ++round) {
    const int begin = round % 7, end = begin + 1 + round % 300;
    std::vector<std::atomic<int>> done(static_cast<std::size_t>(end));
    pool.share(begin, end, 1 + round % 5, [&](int from, int to) {
      for (int i = from; i < to; ++i) ++done[static_cast<std::size_t>(i)];
    });
    for (int i = 0; i < end; ++i)
      ASSERT_EQ(done[static_cast<std::size_t>(i)].load(), i < begin ? 0 : 1) << round;
  }
}

TEST(WorkerPool, RangesAreNoSmallerThanTheGrain) {
  WorkerPool pool(3);
  std::mutex mutex;
  std::vector<int> lengths;
  pool.share(0, 100, 30, [&](int from, int to) {
    const std::scoped_lock lock(mutex);
    lengths.push_back(to - from);
  });
  std::sort(lengths.begin(), lengths.end());
  EXPECT_EQ(lengths, (std::vector<int>{10, 30, 30, 30}));
}

TEST(WorkerPool, TheFirstRangeIsTheCallers) {
  WorkerPool pool(3);
  for (int round = 0; round < 2000; ++round) {
    std::thread::id first;
    pool.share(5, 5 + 1 + round % 9, 1, [&](int from, int) {
      if (from == 5) first = std::this_thread::get_id();
    });
    ASSERT_EQ(first, std::this_thread::get_id()) << round;
  }
}

TEST(WorkerPool, AThreadDoesItsHalf_ThenWhatIsLeftOfTheOthersFromItsEnd) {
  WorkerPool pool(1);
  if (pool.workers() == 0) GTEST_SKIP() << "the machine gives no thread";
  for (int round = 0; round < 50; ++round) {
    std::vector<int> workers;
    std::atomic<int> done{0};
    pool.share(0, 16, 1, [&](int from, int) {
      if (from != 0) workers.push_back(from);  // the caller is held up in its first
      if (from == 0)
        while (done.load() < 15) std::this_thread::yield();
      ++done;
    });
    ASSERT_EQ(workers, (std::vector<int>{8, 9, 10, 11, 12, 13, 14, 15, 7, 6, 5, 4, 3, 2, 1}));
  }
}

TEST(WorkerPool, WhatIsThrownReachesTheCaller_AndTheNextLoopRuns) {
  WorkerPool pool(3);
  for (int round = 0; round < 200; ++round) {
    EXPECT_THROW(pool.share(0, 64, 1,
                            [](int from, int) {
                              if (from % 9 == 5) throw std::runtime_error("no");
                            }),
                 std::runtime_error);
    std::atomic<int> sum{0};
    pool.share(0, 64, 1, [&](int from, int to) { sum += to - from; });
    ASSERT_EQ(sum.load(), 64);
  }
}

TEST(WorkerPool, ALoopInsideOfALoopIsDoneByItsCaller) {
  WorkerPool pool(2);
  std::atomic<int> sum{0};
  pool.share(0, 16, 1, [&](int from, int to) {
    for (int i = from; i < to; ++i)
      pool.share(0, 10, 1, [&](int begin, int end) { sum += end - begin; });
  });
  EXPECT_EQ(sum.load(), 160);
}

/// Waits until something is so, or a minute has passed.
void wait_until(const std::function<bool()>& is_so) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!is_so() && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  ASSERT_TRUE(is_so());
}

TEST(WorkerPool, WorkersThatWaitDoWhatIsOffered) {
  WorkerPool pool(2);
  for (const int pause_ms : {0, 20}) {  // workers that look for work, and such that sleep
    std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
    std::atomic<int> left{100}, done{0};
    const std::function<bool()> piece = [&] {
      if (left.fetch_sub(1) <= 0) return false;
      ++done;
      return true;
    };
    pool.offer(piece);
    wait_until([&] { return done == 100; });
    pool.withdraw();
    EXPECT_EQ(done, 100);
  }
}

TEST(WorkerPool, AfterAnOfferIsWithdrawnNobodyIsAtAPiece) {
  WorkerPool pool(3);
  for (int round = 0; round < 300; ++round) {
    std::atomic<int> inside{0}, calls{0};
    const std::function<bool()> piece = [&] {
      ++inside;
      ++calls;
      std::this_thread::yield();
      --inside;
      return true;
    };
    pool.offer(piece);
    if (round % 2 == 0) wait_until([&] { return calls > 0; });
    pool.withdraw();
    EXPECT_EQ(inside, 0);
    const int before = calls;
    pool.share(0, 8, 1, [](int, int) {});
    ASSERT_EQ(calls, before);
  }
}

TEST(WorkerPool, ALoopDoesNotWaitForAPiece) {
  WorkerPool pool(2);
  std::atomic<int> inside{0}, sum{0};
  std::atomic<bool> loop_is_done{false};
  const std::function<bool()> piece = [&] {
    ++inside;
    while (!loop_is_done) std::this_thread::yield();
    return false;
  };
  pool.offer(piece);
  wait_until([&] { return inside == 2; });
  pool.share(0, 100, 1, [&](int from, int to) { sum += to - from; });
  loop_is_done = true;
  pool.withdraw();
  EXPECT_EQ(sum, 100);
}

TEST(WorkerPool, WhatAPieceThrowsReachesWhoeverWithdrawsTheOffer) {
  WorkerPool pool(2);
  std::atomic<int> calls{0};
  const std::function<bool()> piece = [&]() -> bool {
    ++calls;
    throw std::runtime_error("no");
  };
  pool.offer(piece);
  wait_until([&] { return calls > 0; });
  EXPECT_THROW(pool.withdraw(), std::runtime_error);
  EXPECT_NO_THROW(pool.withdraw());
}

TEST(WorkerPool, AForkedProcessWorksAlone) {
  WorkerPool pool(2);
  const pid_t child = fork();
  if (child == 0) {
    int sum = 0;
    pool.share(0, 100, 1, [&](int from, int to) { sum += to - from; });
    const std::function<bool()> piece = [&] { return ++sum < 0; };
    pool.offer(piece);
    pool.withdraw();
    _exit(sum == 100 ? 7 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 7);
}

TEST(WorkerPool, WorkersRoundToNearestWhateverTheirMakerDoes) {
  std::fenv_t before;
  std::fegetenv(&before);
  std::fesetround(FE_UPWARD);
  WorkerPool pool(3);
  std::fesetenv(&before);
  std::atomic<int> others{0};
  for (int round = 0; round < 200; ++round) {
    pool.share(0, 64, 1, [&](int, int) {
      if (std::fegetround() != FE_TONEAREST) ++others;
    });
  }
  EXPECT_EQ(others.load(), 0);
}

}  // namespace
}  // namespace pentimento

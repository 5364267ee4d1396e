#include "core/base/plain_thread.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <cfenv>
#include <csignal>

namespace pentimento {
namespace {

void run_and_join(const std::function<void()>& work) {
  const auto thread = start_plain_thread(work);
  ASSERT_TRUE(thread);
  pthread_join(*thread, nullptr);
}

TEST(PlainThread, RoundsToNearestWhateverItsMakerDoes) {
  std::fenv_t before;
  std::fegetenv(&before);
  std::fesetround(FE_UPWARD);
  int rounding = -1;
  run_and_join([&] { rounding = std::fegetround(); });
  std::fesetenv(&before);
  EXPECT_EQ(rounding, FE_TONEAREST);
}

TEST(PlainThread, LeavesSignalsToItsMaker) {
  sigset_t there, here;
  run_and_join([&] { pthread_sigmask(SIG_SETMASK, nullptr, &there); });
  pthread_sigmask(SIG_SETMASK, nullptr, &here);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    EXPECT_EQ(sigismember(&there, signal), 1) << signal;
    EXPECT_EQ(sigismember(&here, signal), 0) << signal;
  }
}

}  // namespace
}  // namespace pentimento

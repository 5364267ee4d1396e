// What the command does where the machine gives it little, and when it is told twice to stop.

#include <gtest/gtest.h>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

/// Sanitizers need an address space and stacks of their own.
#if defined(PENTIMENTO_SANITIZED)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

TEST(Guard, ASmallStackIsEnough) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's frames are larger";
  const Workplace place;
  const Ran ran = place.run("render a.jsonl -o a.png", "ulimit -s 64 &&");
  EXPECT_EQ(ran.code, 0) << ran.err;
  ASSERT_EQ(place.run("render a.jsonl -o b.png").code, 0);
  EXPECT_EQ(place.run("compare a.png b.png").code, 0);
}

TEST(Guard, AWantOfMemoryIsOneLineAndLeavesNothing) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's address space is larger";
  const Workplace place;
  int refused = 0;
  for (const int mebibytes : {120, 160, 200, 260}) {
    const Ran ran = place.run("render a.jsonl -o a.png --width 1600 --quiet",
                              "ulimit -v " + std::to_string(mebibytes * 1024) + " &&");
    if (ran.code == 0 || ran.code == 127) continue;  // it fitted; the libraries did not
    ++refused;
    EXPECT_TRUE(ran.code == 4 || ran.code == 5) << mebibytes << ": " << ran.code << ran.err;
    // Mesa, which finds no memory to load itself, may say a line of its own.
    const std::size_t ours = ran.err.find("pentimento: ");
    ASSERT_NE(ours, std::string::npos) << mebibytes << ": " << ran.err;
    EXPECT_EQ(ran.err.find("pentimento: ", ours + 1), std::string::npos) << ran.err;
    EXPECT_EQ(place.files(), 1U) << mebibytes;
  }
  EXPECT_GT(refused, 0);
}

TEST(Guard, AHangupCleansUpAsTheOtherSignalsDo) {
  if (kSanitized) GTEST_SKIP() << "it may not have begun to listen when the signal comes";
  const Workplace place;
  for (const std::string signal : {"HUP", "TERM", "INT"}) {
    const Ran ran =
        place.run("render a.jsonl -o a.png --width 16000 --quiet", signalled(signal, "1.5"));
    EXPECT_EQ(ran.code, 75) << signal << ran.err;
    EXPECT_EQ(place.files(), 1U) << signal;
  }
}

TEST(Guard, AWaitForAPipeIsInterrupted) {
  const Workplace place;
  const Ran ran = place.run("render - -o a.png --quiet", "sleep 6 | " + signalled("TERM", "1.5"));
  EXPECT_EQ(ran.code, 75) << ran.err;
}

}  // namespace
}  // namespace pentimento::test

// What the command does where the machine gives it little, and when it is told twice to stop.

#include <gtest/gtest.h>

#include "tests/cli/command_run.h"
#include "tests/sanitized.h"

namespace pentimento::test {
namespace {

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
  for (const int mebibytes : {120, 160, 200, 220, 240, 260, 300, 350, 400}) {
    const Ran ran = place.run("render a.jsonl -o a.png --width 1600 --quiet",
                              "ulimit -v " + std::to_string(mebibytes * 1024) + " &&");
    if (ran.code == 0 || ran.code == 127) continue;  // it fitted; the libraries did not
    ++refused;
    EXPECT_TRUE(ran.code == 4 || ran.code == 5) << mebibytes << ": " << ran.code << ran.err;
    // A library whose heap is damaged by then may have last words before it crashes.
    const std::size_t ours = ran.err.find("pentimento: ");
    ASSERT_NE(ours, std::string::npos) << mebibytes << ": " << ran.err;
    EXPECT_EQ(lines_in(ran.err.substr(ours)), 1U) << mebibytes << ": " << ran.err;
    if (ran.err.find("crashed") == std::string::npos) {
      EXPECT_EQ(ours, 0U) << ran.err;
    }
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

TEST(Guard, AWaitForAReaderIsInterrupted) {
  Workplace place;
  std::string log = kSmallLog;  // a pipe holds 64 KiB, so this is too long for one
  for (int i = 2; i < 6000; ++i)
    log += R"({"t":)" + std::to_string(i) + R"(,"type":"mark","name":"a"})" + "\n";
  place.write("long.jsonl", log);
  place.run("convert long.jsonl -o - 2> words; echo $? > code; } | sleep 4",
            "{ " + signalled("TERM", "1"));
  EXPECT_EQ(place.read("code"), "75\n");
  EXPECT_EQ(place.read("words"), "pentimento: standard output: interrupted\n");
}

TEST(Guard, AWaitForAPipeIsInterrupted) {
  const Workplace place;
  const Ran ran = place.run("render - -o a.png --quiet", "sleep 6 | " + signalled("TERM", "1.5"));
  EXPECT_EQ(ran.code, 75) << ran.err;
}

}  // namespace
}  // namespace pentimento::test

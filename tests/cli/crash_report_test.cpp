// What is left of a run that crashes. A signal from outside stands for a fault in the code.

#include <gtest/gtest.h>

#include <csignal>

#include "tests/cli/command_run.h"
#include "tests/sanitized.h"

namespace pentimento::test {
namespace {

constexpr int kKilledBy = 128;  // what `timeout` and shells add to a signal's number

/// The command gets the signal while the temporary file of a large picture is there.
void expect_clean_end(const std::string& signal, int number, const std::string& words) {
  SCOPED_TRACE(signal);
  const Workplace place;
  const Ran ran =
      place.run("render a.jsonl -o a.png --width 16000 --quiet", signalled(signal, "1.5"));
  EXPECT_EQ(ran.code, kKilledBy + number);
  EXPECT_EQ(ran.err, words);
  EXPECT_EQ(place.files(), 1U);
}

TEST(CrashReport, ACrashIsOneLineLeavesNothingAndEndsByItsSignal) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer reports it";
  expect_clean_end("SEGV", SIGSEGV,
                   "pentimento: internal error: crashed; no output is half written\n");
}

TEST(CrashReport, WhoAbortsHasSaidWhy) {
  if (kSanitized) GTEST_SKIP() << "it may not have begun to listen when the signal comes";
  expect_clean_end("ABRT", SIGABRT, "");
}

TEST(CrashReport, CloseToALimitOfMemoryACrashIsALimitsError) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer's address space is larger";
  const Workplace place;
  // It waits for the pipe, with less than 64 MiB mapped.
  const std::string waits = "render - -o a.png --quiet";
  const auto crashed = [&](const std::string& kibibytes) {
    return place.run(waits, "ulimit -v " + kibibytes + " && sleep 4 | " + signalled("SEGV", "1"));
  };
  const Ran close = crashed("200000");
  EXPECT_EQ(close.code, 4);
  EXPECT_EQ(close.err,
            "pentimento: crashed close to the limit of its memory (`ulimit -v`); no output is half "
            "written\n");
  const Ran far = crashed("2000000");
  EXPECT_EQ(far.code, kKilledBy + SIGSEGV) << far.err;
}

}  // namespace
}  // namespace pentimento::test

// What is left of a run that crashes. A signal from outside stands for a fault in the code.

#include <gtest/gtest.h>

#include <csignal>

#include "tests/cli/command_run.h"
#include "tests/sanitized.h"

namespace pentimento::test {
namespace {

/// A picture that takes seconds: the signal comes while its temporary file is there.
const std::string kSlow = "render a.jsonl -o a.png --width 16000 --quiet";
constexpr int kKilledBy = 128;  // what `timeout` and shells add to a signal's number

TEST(CrashReport, ACrashIsOneLineLeavesNothingAndEndsByItsSignal) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer reports it";
  const Workplace place;
  const Ran ran = place.run(kSlow, signalled("SEGV", "1.5"));
  EXPECT_EQ(ran.code, kKilledBy + SIGSEGV);
  EXPECT_EQ(ran.err, "pentimento: internal error: crashed; no output is half written\n");
  EXPECT_EQ(place.files(), 1U);
}

TEST(CrashReport, WhoAbortsHasSaidWhy) {
  if (kSanitized) GTEST_SKIP() << "it may not have begun to listen when the signal comes";
  const Workplace place;
  const Ran ran = place.run(kSlow, signalled("ABRT", "1.5"));
  EXPECT_EQ(ran.code, kKilledBy + SIGABRT);
  EXPECT_EQ(ran.err, "");
  EXPECT_EQ(place.files(), 1U);
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

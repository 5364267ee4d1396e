#include "replay/process/child.h"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

class ChildTest : public ::testing::Test {
 protected:
  ChildSpec spec_of(const std::string& script) const {
    ChildSpec spec;
    spec.program = "/bin/sh";
    spec.words = {"-c", script};
    spec.folder = scratch_.path("");
    spec.output_file = scratch_.path("out");
    spec.message_file = scratch_.path("err");
    return spec;
  }
  static ChildDone wait(Child& child) {
    while (!child.has_ended()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return child.done();
  }
  ChildDone run(const ChildSpec& spec) const {
    Result<std::unique_ptr<Child>> child = Child::start(spec);
    return child ? wait(**child) : ChildDone{};
  }

  test::Scratch scratch_;
};

TEST_F(ChildTest, TellsTheExitCodeAndKeepsWhatWasSaid) {
  const ChildDone done = run(spec_of("echo out; echo err >&2; exit 7"));
  EXPECT_EQ(done.end, ChildEnd::kExit);
  EXPECT_EQ(done.code, 7);
  EXPECT_EQ(test::slurp(scratch_.path("out")), "out\n");
  EXPECT_EQ(test::slurp(scratch_.path("err")), "err\n");
  EXPECT_GT(done.peak_memory_bytes, 100000) << "a shell";
}

TEST_F(ChildTest, ACrashIsASignal) {
  const ChildDone done = run(spec_of("kill -SEGV $$"));
  EXPECT_EQ(done.end, ChildEnd::kSignal);
  EXPECT_EQ(done.code, SIGSEGV);
}

// A new process is a copy of its parent at first, with all of the parent's memory.
TEST_F(ChildTest, ItsMemoryIsItsOwnFromTheBeginning) {
  const std::vector<char> much(std::size_t{200} << 20, 1);
  ChildSpec spec = spec_of("exit 0");
  spec.memory_bytes = 100'000'000;
  for (int i = 0; i < 10; ++i) EXPECT_EQ(run(spec).end, ChildEnd::kExit);
  EXPECT_EQ(much.back(), 1);
}

TEST_F(ChildTest, AHangIsEndedAndSoIsWhatItStarted) {
  ChildSpec spec = spec_of("sleep 100 & echo $! > pid; wait");
  spec.timeout_s = 0.3;
  const ChildDone done = run(spec);
  EXPECT_EQ(done.end, ChildEnd::kTimeout);
  EXPECT_LT(done.wall_s, 5);
  const int started = std::stoi(test::slurp(scratch_.path("pid")));
  for (int i = 0; i < 500 && kill(started, 0) == 0; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  // Nobody may have waited for it yet; then it is dead all the same.
  const std::string status =
      kill(started, 0) == 0 ? test::slurp("/proc/" + std::to_string(started) + "/stat") : ") Z";
  EXPECT_NE(status.find(") Z"), std::string::npos) << status;
}

TEST_F(ChildTest, OneThatHoldsTooMuchMemoryIsEnded) {
  // A variable of 64 MB, which a shell holds in memory.
  ChildSpec spec = spec_of("x=$(head -c 64000000 /dev/zero | tr '\\0' x); sleep 100");
  spec.memory_bytes = 30'000'000;
  const ChildDone done = run(spec);
  EXPECT_EQ(done.end, ChildEnd::kMemory);
  EXPECT_GT(done.peak_memory_bytes, spec.memory_bytes);
}

TEST_F(ChildTest, StopsWhenItIsTold) {
  Result<std::unique_ptr<Child>> child = Child::start(spec_of("sleep 100"));
  ASSERT_TRUE(child);
  (*child)->stop();
  EXPECT_EQ(wait(**child).end, ChildEnd::kStopped);
}

TEST_F(ChildTest, AProgramThatIsNotThereEndsAsAShellSaysIt) {
  ChildSpec spec = spec_of("");
  spec.program = "/nowhere/program";
  const ChildDone done = run(spec);
  EXPECT_EQ(done.end, ChildEnd::kExit);
  EXPECT_EQ(done.code, 127);
}

}  // namespace
}  // namespace pentimento

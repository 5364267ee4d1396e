// No input is lost, no file is written twice, and what killed runs left goes.

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/command_run.h"

namespace pentimento::test {
namespace {

class ClaimedOutputs : public testing::Test {
 protected:
  /// The command refuses, and `input` has the bytes that it had.
  void expect_refused(const std::string& arguments, const std::string& input,
                      const std::string& message) const {
    const std::string before = place_.read(input);
    const std::size_t files = place_.files();
    const Ran ran = place_.run(arguments);
    EXPECT_EQ(ran.code, 2) << arguments;
    EXPECT_EQ(ran.err, "pentimento: " + message + "\n") << arguments;
    EXPECT_EQ(place_.read(input), before) << arguments;
    EXPECT_EQ(place_.files(), files) << arguments;
  }
  Workplace place_;
};

TEST_F(ClaimedOutputs, TheLogStaysUnderAnyName) {
  place_.write("log.png", kSmallLog);
  std::filesystem::create_symlink("log.png", place_.path("link.png"));
  std::filesystem::create_hard_link(place_.path("log.png"), place_.path("hard.png"));
  for (const std::string name : {"log.png", "link.png", "hard.png"}) {
    expect_refused("render log.png -o " + name, "log.png",
                   "-o " + name + ": would replace the log");
    expect_refused("render - -o " + name + " < log.png", "log.png",
                   "-o " + name + ": would replace the log");
  }
  expect_refused("render log.png -o new.png --hashes link.png", "log.png",
                 "-o link.png: would replace the log");
  expect_refused("convert log.png --speed 2 -o log.png", "log.png",
                 "-o log.png: would replace the recording");
}

TEST_F(ClaimedOutputs, DumpsTexturesAndLightStay) {
  ASSERT_EQ(place_.run("render a.jsonl -o s.h5 -o sky.exr -o sky.height.png --width 40").code, 0);
  expect_refused("render a.jsonl --from s.h5 -o s.h5", "s.h5",
                 "-o s.h5: would replace the state of --from");
  expect_refused("relight s.h5 --environment sky.exr -o sky.exr", "sky.exr",
                 "-o sky.exr: would replace the picture of --environment");
  std::string log = kSmallLog;
  log.insert(log.find("\"canvas\""), R"("paper":{"texture":"sky.height.png"},)");
  place_.write("textured.jsonl", log);
  const std::string kept = ": would replace \"sky.height.png\", which the log names";
  expect_refused("render textured.jsonl -o sky.height.png", "sky.height.png",
                 "-o sky.height.png" + kept);
  // The name of a layer beside a picture is known only when the layer is written.
  expect_refused("render textured.jsonl -o sky.png --aov height", "sky.height.png",
                 "-o sky.height.png" + kept);
}

TEST_F(ClaimedOutputs, OneFileUnderTwoNamesIsRefused) {
  std::filesystem::create_symlink("new.png", place_.path("link.png"));
  expect_refused("render a.jsonl -o new.png -o link.png", "a.jsonl",
                 "-o link.png: is the same file as new.png");
}

TEST_F(ClaimedOutputs, ALinkToNothingIsFollowed) {
  std::filesystem::create_directory(place_.path("pictures"));
  std::filesystem::create_symlink("pictures/new.png", place_.path("link.png"));
  ASSERT_EQ(place_.run("render a.jsonl -o link.png").code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(place_.path("link.png")));
  EXPECT_TRUE(std::filesystem::is_regular_file(place_.path("pictures/new.png")));
}

TEST_F(ClaimedOutputs, AKilledRunLeavesNothingAfterTheNext) {
  // Killed when its picture has begun: at its first rename, which gives the picture its name.
  const std::string kill_at_work =
      "sh -c '\"$0\" \"$@\" & n=0; while ! ls -A | grep -q part && [ $n -lt 2000 ]; do n=$((n+1)); "
      "sleep 0.01; done; kill -9 $!; wait $! 2>/dev/null'";
  place_.run("render a.jsonl -o big.png --width 3000 --quiet", kill_at_work);
  ASSERT_GT(place_.files(), 1U) << "the killed run left something";
  ASSERT_EQ(place_.run("render a.jsonl -o a.png").code, 0);
  EXPECT_EQ(place_.files(), 2U);
}

TEST_F(ClaimedOutputs, TwoRunsDoNotWriteOneFile) {
  // The second begins when the first has its lock, and ends before it.
  const std::string both =
      "sh -c '\"$0\" \"$@\" --quiet & n=0; while ! ls -A | grep -q lock && [ $n -lt 2000 ]; do "
      "n=$((n+1)); sleep 0.01; done; \"$0\" \"$@\"; code=$?; wait $!; exit $((10 * $? + code))'";
  const Ran ran = place_.run("render a.jsonl -o big.png --width 3000", both);
  EXPECT_EQ(ran.code, 2) << "0 of the first, 2 of the second";
  EXPECT_NE(ran.err.find("-o big.png: another run is writing it\n"), std::string::npos) << ran.err;
  EXPECT_EQ(place_.files(), 2U);
}

}  // namespace
}  // namespace pentimento::test

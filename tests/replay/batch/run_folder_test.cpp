#include "replay/batch/run_folder.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iterator>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

const std::string kKey(64, 'a');

class RunFolderTest : public ::testing::Test {
 protected:
  /// Keeps a result that wrote a file of this name.
  JobResult keep(const std::string& state, ChildEnd end, const std::string& file) {
    JobResult result;
    result.key = kKey;
    result.state_sha256 = state;
    result.done.end = end;
    const std::string work = *run.begin(kKey);
    test::spill(work + "/" + file, "x");
    return *run.keep(result, work);
  }

  std::size_t folders_of_results() const {
    const std::filesystem::directory_iterator entries(scratch.path("run/results"));
    return static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
  }

  test::Scratch scratch;
  RunFolder run = *RunFolder::make(scratch.path("run"));
};

TEST_F(RunFolderTest, AResultAppearsWithItsFiles) {
  EXPECT_FALSE(run.find(kKey));
  keep("s", ChildEnd::kExit, "picture.png");
  ASSERT_TRUE(run.find(kKey));
  EXPECT_EQ(run.find(kKey)->state_sha256, "s");
  EXPECT_TRUE(std::filesystem::exists(run.file_of(kKey, "picture.png")));
  // The SHA-256 of "x" (FIPS 180-4, by sha256sum).
  EXPECT_EQ(run.hash_of(kKey, "picture.png"),
            "2d711642b726b04401627ca9fbac32f5c8530fb1903cc4db02258717921a4881");
  EXPECT_EQ(run.hash_of(kKey, "state.h5"), "");
}

TEST_F(RunFolderTest, WhatStandsStaysAndGetsWhatItLacks) {
  keep("s", ChildEnd::kExit, "picture.png");
  EXPECT_EQ(keep("other", ChildEnd::kExit, "state.h5").state_sha256, "s");
  EXPECT_FALSE(std::filesystem::exists(run.file_of(kKey, "state.h5"))) << "of another state";
  keep("s", ChildEnd::kExit, "state.h5");
  EXPECT_TRUE(std::filesystem::exists(run.file_of(kKey, "state.h5")));
}

TEST_F(RunFolderTest, WhatAKilledProcessHadBegunIsRemovedByTheNext) {
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string work = *run.begin(kKey);
    test::spill(work + "/picture.png", "half a picture");
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(child, nullptr, 0);
  const std::string mine = *run.begin(kKey);
  EXPECT_EQ(folders_of_results(), 2U);
  ASSERT_TRUE(RunFolder::make(scratch.path("run")));
  EXPECT_EQ(folders_of_results(), 1U);
  EXPECT_TRUE(std::filesystem::exists(mine)) << "of a process that lives";
}

TEST_F(RunFolderTest, WhatEndedByChanceIsReplaced) {
  keep("", ChildEnd::kTimeout, "messages.txt");
  keep("s", ChildEnd::kExit, "picture.png");
  EXPECT_EQ(run.find(kKey)->state_sha256, "s");
  EXPECT_FALSE(std::filesystem::exists(run.file_of(kKey, "messages.txt")));
  EXPECT_EQ(folders_of_results(), 1U);
}

TEST_F(RunFolderTest, ATornResultIsNone) {
  keep("s", ChildEnd::kExit, "picture.png");
  test::spill(run.file_of(kKey, "result.json"), "{\"key\":");
  EXPECT_FALSE(run.find(kKey));
}

TEST_F(RunFolderTest, RowsAreFoundByTheirIds) {
  BatchRow row;
  row.id = "a/b \xC3\xA9";
  row.kind = RowKind::kPassed;
  ASSERT_TRUE(run.write_row(row));
  ASSERT_TRUE(run.row(row.id));
  EXPECT_TRUE(run.row(row.id)->passed());
  EXPECT_FALSE(run.row("a"));
}

TEST_F(RunFolderTest, AFolderThatIsNoRunIsRefused) {
  EXPECT_EQ(RunFolder::open(scratch.path("nowhere")).error().code, ErrorCode::kBadInput);
}

}  // namespace
}  // namespace pentimento

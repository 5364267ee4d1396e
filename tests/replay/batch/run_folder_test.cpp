#include "replay/batch/run_folder.h"

#include <gtest/gtest.h>

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

TEST_F(RunFolderTest, WhatEndedByChanceIsReplaced) {
  keep("", ChildEnd::kTimeout, "messages.txt");
  keep("s", ChildEnd::kExit, "picture.png");
  EXPECT_EQ(run.find(kKey)->state_sha256, "s");
  EXPECT_FALSE(std::filesystem::exists(run.file_of(kKey, "messages.txt")));
  std::size_t folders = 0;
  for ([[maybe_unused]] const auto& one :
       std::filesystem::directory_iterator(scratch.path("run/results")))
    ++folders;
  EXPECT_EQ(folders, 1U);
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

#include "replay/batch/matching_files.h"

#include <gtest/gtest.h>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

TEST(MatchingFiles, AreSortedAndNamedByWhatWasMatched) {
  const test::Scratch scratch;
  // The folder's own name is no pattern.
  const std::string folder = scratch.path("night[1]*");
  std::filesystem::create_directories(folder + "/in");
  for (const char* name : {"in/b.jsonl", "in/a.jsonl.zst", "in/c.txt"})
    test::spill(folder + "/" + name, "");
  const std::vector<MatchingFile> files = matching_files(folder, "in/?.jsonl*");
  ASSERT_EQ(files.size(), 2U);
  EXPECT_EQ(files[0].path, "in/a.jsonl.zst");
  EXPECT_EQ(files[0].name, "a");
  EXPECT_EQ(files[1].name, "b");
  EXPECT_TRUE(matching_files(folder, "in/b.jsonl").empty()) << "no wildcard";
  EXPECT_TRUE(matching_files(folder, "in/*.none").empty());
}

TEST(MatchingFiles, APatternMayBeginAtTheRoot) {
  const test::Scratch scratch;
  test::spill(scratch.path("a.jsonl"), "");
  const std::vector<MatchingFile> files = matching_files("/nowhere", scratch.path("*.jsonl"));
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].path, scratch.path("a.jsonl"));
  EXPECT_EQ(files[0].name, "a");
}

}  // namespace
}  // namespace pentimento

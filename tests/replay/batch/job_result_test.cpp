#include "replay/batch/job_result.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/cli/command_run.h"

namespace pentimento {
namespace {

JobInputs inputs(const test::Workplace& place, std::vector<std::string> options,
                 const std::string& build = "b") {
  BatchJob job;
  job.id = "a";
  job.log = "a.jsonl";
  job.options = std::move(options);
  return inputs_of(job, place.path(""), build);
}

TEST(JobInputs, TheKeyIsThatOfEverythingThatCountsAndOfNothingElse) {
  test::Workplace place;
  place.write("light.hdr", "one");
  const std::string key = inputs(place, {"--environment", "light.hdr"}).key();
  EXPECT_EQ(inputs(place, {"--environment", "light.hdr", "--threads", "3"}).key(), key);
  EXPECT_EQ(inputs(place, {"--memory-limit=1G", "--environment", "light.hdr"}).key(), key);
  EXPECT_NE(inputs(place, {"--environment", "light.hdr", "--detail", "2"}).key(), key);
  EXPECT_NE(inputs(place, {"--environment", "light.hdr"}, "another build").key(), key);
  place.write("light.hdr", "two");
  EXPECT_NE(inputs(place, {"--environment", "light.hdr"}).key(), key) << "a file of an option";
  place.write("light.hdr", "one");
  EXPECT_EQ(inputs(place, {"--environment", "light.hdr"}).key(), key);
  place.write("a.jsonl", test::kSmallLog + R"({"t":2,"type":"mark","name":"later"})" + "\n");
  EXPECT_NE(inputs(place, {"--environment", "light.hdr"}).key(), key) << "the log";
}

TEST(JobInputs, AFileThatTheLogNamesCounts) {
  test::Workplace place;
  std::string log = test::kSmallLog;
  log.replace(log.find(R"("palette")"), 0, R"("paper":{"texture":"paper.png"},)");
  ASSERT_EQ(place.run("render a.jsonl -o paper.png --width 40").code, 0);
  place.write("a.jsonl", log);
  const std::string key = inputs(place, {}).key();
  place.write("plain.jsonl", test::kSmallLog);
  ASSERT_EQ(place.run("render plain.jsonl -o paper.png --width 50").code, 0);
  EXPECT_NE(inputs(place, {}).key(), key);
}

TEST(JobInputs, OutsideOfTheLogsFolderNothingIsReadUnlessTheOptionsSay) {
  test::Workplace place;
  std::string log = test::kSmallLog;
  ASSERT_EQ(place.run("render a.jsonl -o paper.png --width 40").code, 0);
  log.replace(log.find(R"("palette")"), 0, R"("paper":{"texture":"../paper.png"},)");
  std::filesystem::create_directory(place.path("logs"));
  place.write("logs/a.jsonl", log);
  BatchJob job;
  job.id = "a";
  job.log = "logs/a.jsonl";
  EXPECT_TRUE(inputs_of(job, place.path(""), "b").files.empty());
  job.options = {"--allow-outside"};
  EXPECT_EQ(inputs_of(job, place.path(""), "b").files.count("../paper.png"), 1u);
}

TEST(JobResult, OnlyWhatAMachineDidIsTriedAgain) {
  JobResult result;
  EXPECT_TRUE(result.is_final());
  result.done.code = 3;
  EXPECT_TRUE(result.is_final()) << "a bad log stays bad";
  for (const int code : {5, 75, 127}) {
    result.done.code = code;
    EXPECT_FALSE(result.is_final()) << code;
  }
  result.done.code = 0;
  for (const ChildEnd end :
       {ChildEnd::kSignal, ChildEnd::kTimeout, ChildEnd::kMemory, ChildEnd::kStopped}) {
    result.done.end = end;
    EXPECT_FALSE(result.is_final()) << name_of(end);
  }
}

}  // namespace
}  // namespace pentimento

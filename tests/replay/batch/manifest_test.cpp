#include "replay/batch/manifest.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

std::string problem_of(const std::string& lines) {
  const Result<std::vector<BatchJob>> jobs = parse_manifest(lines, "m.jsonl");
  return jobs ? "" : jobs.error().message;
}

TEST(Manifest, ReadsEveryField) {
  const std::string line =
      R"({"id":"a b","log":"x.jsonl","options":["--detail","2"],"timeout_s":1.5,)"
      R"("memory_bytes":2000000,"expect":{"exit":3,"state_sha256":"ab","flip":0.1,"psnr":30,"max":0.5}})";
  const Result<std::vector<BatchJob>> jobs = parse_manifest("\n" + line + "\n\n", "m.jsonl");
  ASSERT_TRUE(jobs) << jobs.error().message;
  const BatchJob& job = jobs->front();
  EXPECT_EQ(job.id, "a b");
  EXPECT_EQ(job.log, "x.jsonl");
  EXPECT_EQ(job.options, (std::vector<std::string>{"--detail", "2"}));
  EXPECT_EQ(job.timeout_s, 1.5);
  EXPECT_EQ(job.memory_bytes, 2000000);
  EXPECT_EQ(job.expect.exit_code, 3);
  EXPECT_EQ(job.expect.state_sha256, "ab");
  EXPECT_EQ(job.expect.picture.flip, 0.1);
  EXPECT_EQ(job.expect.picture.psnr_db, 30);
  EXPECT_EQ(job.expect.picture.max, 0.5);
  EXPECT_TRUE(job.expect.any_state) << "who allows another picture allows another state";
}

TEST(Manifest, TextReadsBackAsTheSameJobs) {
  const std::string text =
      R"({"id":"a","log":"x.jsonl","expect":{"flip":0.25,"state":"same"},"timeout_s":2})"
      "\n"
      R"({"id":"b","log":"y.jsonl","options":["--set","model.nu_max=1"],"expect":{"state":"any"}})"
      "\n";
  const std::string once = manifest_text(*parse_manifest(text, "m"));
  EXPECT_EQ(manifest_text(*parse_manifest(once, "m")), once);
  EXPECT_FALSE(parse_manifest(once, "m")->front().expect.any_state);
  EXPECT_TRUE(parse_manifest(once, "m")->back().expect.any_state);
}

TEST(Manifest, SaysWhatIsWrongAndWhere) {
  const std::string good = "{\"id\":\"a\",\"log\":\"x\"}\n";
  EXPECT_EQ(problem_of(good + "[1]\n"), "m.jsonl:2: not a JSON object");
  EXPECT_EQ(problem_of(good + good), "m.jsonl:2: a second job has the id \"a\"");
  EXPECT_EQ(problem_of(R"({"log":"x"})"), "m.jsonl:1: \"id\" is missing");
  EXPECT_EQ(problem_of(R"({"id":"a"})"), "m.jsonl:1: \"log\" is missing");
  EXPECT_EQ(problem_of(R"({"id":"a","log":"-"})"), "m.jsonl:1: \"log\" is not the name of a file");
  EXPECT_EQ(problem_of(R"({"id":"a\n","log":"x"})"), "m.jsonl:1: \"id\" holds a control character");
  EXPECT_EQ(problem_of(R"({"id":"a","log":"x","optoins":[]})"),
            "m.jsonl:1: no field is called \"optoins\" (did you mean \"options\"?)");
  EXPECT_EQ(problem_of(R"({"id":"a","log":"x","expect":{"psnr":"x"}})"),
            "m.jsonl:1: \"psnr\" is not a number from 0 to 1000");
  EXPECT_EQ(problem_of(R"({"id":"a","log":"x","options":["-o","y.png"]})"),
            "m.jsonl:1: \"options\": -o is the batch's own");
  EXPECT_EQ(problem_of(R"({"id":"a","log":"x","expect":{"state":"none"}})"),
            "m.jsonl:1: \"state\" is neither \"same\" nor \"any\"");
}

TEST(Manifest, APatternIsAJobForEachFile) {
  const test::Scratch scratch;
  std::filesystem::create_directories(scratch.path("logs/a"));
  test::spill(scratch.path("logs/a/one.jsonl"), "");
  test::spill(scratch.path("logs/a/two.jsonl.gz"), "");
  test::spill(scratch.path("m.jsonl"),
              "{\"id\":\"n\",\"log\":\"logs/*/*.jsonl*\"}\n{\"id\":\"none\",\"log\":\"*.none\"}\n");
  const Result<Manifest> manifest = read_manifest(scratch.path("m.jsonl"));
  ASSERT_TRUE(manifest) << manifest.error().message;
  std::map<std::string, std::string> logs;
  for (const BatchJob& job : manifest->jobs) logs[job.id] = job.log;
  EXPECT_EQ(logs, (std::map<std::string, std::string>{{"n/a/one", "logs/a/one.jsonl"},
                                                      {"n/a/two", "logs/a/two.jsonl.gz"},
                                                      {"none", "*.none"}}));
}

TEST(Manifest, AnEmptyOneIsRefused) {
  const test::Scratch scratch;
  test::spill(scratch.path("m.jsonl"), "\n");
  EXPECT_EQ(read_manifest(scratch.path("m.jsonl")).error().code, ErrorCode::kBadInput);
}

TEST(ShardOf, EachIdIsInOneShardAndTheSharesAreEven) {
  std::map<int, int> sizes;
  for (int i = 0; i < 900; ++i) ++sizes[shard_of("id " + std::to_string(i), 3)];
  ASSERT_EQ(sizes.size(), 3U);
  // 300 each, with a deviation of 14: six of those.
  for (const auto& [shard, size] : sizes) EXPECT_NEAR(size, 300, 85) << shard;
  EXPECT_EQ(shard_of("x", 1), 1);
  // SHA-256 of "abc" begins with ba7816bf8f01cfe: 839868466921495806, which is 7 * n + 4.
  EXPECT_EQ(shard_of("abc", 7), static_cast<int>(0xba7816bf8f01cfeULL % 7) + 1);
}

}  // namespace
}  // namespace pentimento

#include "replay/commands/verify.h"

#include <gtest/gtest.h>

#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::JobFolder;

class VerifyTest : public ::testing::Test {
 protected:
  VerifyTest() {
    RenderJob job = folder.job({});
    job.hashes = folder.path("a.hashes");
    job.command = "pentimento render a.jsonl";
    test::rendered(job);
    request.job = folder.job({});
    request.hashes = job.hashes;
  }
  VerifyReport verified() const {
    Result<VerifyReport> report = verify(request, {});
    EXPECT_TRUE(report) << report.error().message;
    return report ? std::move(*report) : VerifyReport();
  }

  JobFolder folder;
  VerifyRequest request;
};

TEST_F(VerifyTest, TheSameReplayIsEqualOnAnyNumberOfThreads) {
  for (const int threads : {1, 2, 7}) {
    request.job.threads = threads;
    const VerifyReport report = verified();
    EXPECT_FALSE(report.difference) << threads;
    EXPECT_GT(report.steps, 30) << "1.2 s at 45 steps a second, less those that are idle";
  }
}

// What the change touches first is known: a parameter of deposits is felt at the first stamp.
TEST_F(VerifyTest, NamesTheFirstStepEventFieldAndTile) {
  request.job.model = {{"film_pigment", "0.041"}};
  const VerifyReport report = verified();
  ASSERT_TRUE(report.difference);
  EXPECT_EQ(report.difference->step, 5) << "0.1 s is in the fifth step";
  EXPECT_EQ(report.event, "touch");
  EXPECT_EQ(report.difference->line, 4) << "the sample to which the first stamps lead";
  const std::vector<std::string>& fields = report.difference->fields;
  EXPECT_NE(std::find(fields.begin(), fields.end(), "/layers/pigment"), fields.end());
  ASSERT_FALSE(report.difference->tiles.empty());
  // The touch begins at 0.1 m, 0.1 m: cell 20, 20, with a brush of 6 cells.
  const CellBox tile = report.difference->tiles.front();
  EXPECT_LE(tile.x0, 20);
  EXPECT_GT(tile.x1, 14);
  for (const int threads : {2, 7}) {
    request.job.threads = threads;
    EXPECT_EQ(verify_json(verified()), verify_json(report)) << threads;
  }
}

TEST_F(VerifyTest, AChangeOfGravityShowsInTheSleepOfTilesBeforePaintRuns) {
  request.job.gravity = std::array<double, 3>{3, 3, 9};
  const VerifyReport report = verified();
  ASSERT_TRUE(report.difference);
  EXPECT_EQ(report.difference->step, 1);
  EXPECT_EQ(report.difference->last_equal_step, 0);
  EXPECT_EQ(report.difference->fields, std::vector<std::string>{"/fluid/asleep"});
}

TEST_F(VerifyTest, WritesTheStatesWhereTheyPart) {
  request.job.model = {{"brush_push", "0.21"}};
  request.dumps = folder.path("state-%.h5");
  const VerifyReport report = verified();
  ASSERT_TRUE(report.difference);
  const std::size_t expected = report.difference->last_equal_step > 0 ? 2U : 1U;
  EXPECT_EQ(report.dumps.size(), expected);
  EXPECT_EQ(folder.says("state-after.h5", "step"), std::to_string(report.difference->step));
}

TEST_F(VerifyTest, TheProgramThatRecordedIsAskedForItsState) {
  request.job.model = {{"film_pigment", "0.041"}};
  request.dumps = folder.path("state-%.h5");
  // One that writes what it is told, but knows nothing of the change.
  folder.write("old", "#!/bin/sh\nexec " PENTIMENTO_COMMAND
                      " \"$1\" \"$2\" \"$3\" \"$4\" --quiet --at \"$7\"\n");
  std::filesystem::permissions(folder.path("old"), std::filesystem::perms::owner_all);
  request.recorded_by = folder.path("old");
  const VerifyReport report = verified();
  EXPECT_EQ(report.dumps.back(), folder.path("state-recorded.h5"));
  EXPECT_NE(report.comparison.find("different"), std::string::npos) << report.comparison;
  EXPECT_NE(report.comparison.find("/layers/pigment"), std::string::npos);
}

TEST_F(VerifyTest, AStepMoreOrLessIsADifference) {
  const std::string all = test::slurp(request.hashes);
  const std::size_t last = all.rfind('\n', all.size() - 2) + 1;
  test::spill(request.hashes, all.substr(0, last));
  ASSERT_TRUE(verified().difference);
  EXPECT_EQ(verified().difference->note, "the recorded replay has no step any more");
  std::string longer = all + all.substr(last);
  test::spill(request.hashes, longer);
  EXPECT_EQ(verified().difference->note, "the recorded replay goes on");
}

TEST_F(VerifyTest, RefusesWhatDoesNotBelongTogether) {
  folder.write("a.jsonl", test::kSmallLog + R"({"t":2,"type":"mark","name":"x"})" + "\n");
  const Result<VerifyReport> report = verify(request, {});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().message.find("recorded from another log"), std::string::npos);
  request.dumps = "state.h5";
  EXPECT_EQ(verify(request, {}).error().code, ErrorCode::kUsage);
  request.dumps = "";
  request.recorded_by = "old";
  EXPECT_EQ(verify(request, {}).error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace pentimento

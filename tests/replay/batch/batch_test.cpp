#include "replay/batch/batch.h"

#include <gtest/gtest.h>

#include <thread>

#include "tests/replay/batch/made_batch.h"

namespace pentimento {
namespace {

using test::MadeBatch;

TEST(Batch, WhateverAJobDoesTheOthersAreDone) {
  MadeBatch batch;
  batch.add("well", "ok");
  batch.add("crash", "crash");
  batch.add("hang", "hang", R"(,"timeout_s":0.3)");
  batch.add("bad", "exit 3");
  batch.add("missing", "missing");
  batch.add("as expected", "exit 4", R"(,"expect":{"exit":4})");
  batch.add("other state", "ok 2", R"(,"expect":{"state_sha256":"00"})");
  const BatchSummary summary = batch.run();
  EXPECT_EQ(summary.rows.size(), 7U);
  EXPECT_EQ(summary.rendered, 7);
  EXPECT_EQ(summary.failed(), 5);
  EXPECT_TRUE(MadeBatch::row(summary, "well").passed());
  EXPECT_TRUE(MadeBatch::row(summary, "as expected").passed());
  EXPECT_EQ(MadeBatch::row(summary, "crash").kind, RowKind::kCrash);
  EXPECT_EQ(MadeBatch::row(summary, "hang").kind, RowKind::kTimeout);
  EXPECT_EQ(MadeBatch::row(summary, "other state").kind, RowKind::kState);
  EXPECT_EQ(MadeBatch::row(summary, "bad").kind, RowKind::kExit);
  EXPECT_EQ(MadeBatch::row(summary, "bad").reasons.front(), "exit code 3 instead of 0: said so");
}

TEST(Batch, WhatIsDoneIsNotDoneAgainButWhatAMachineDidIs) {
  MadeBatch batch;
  batch.add("well", "ok");
  batch.add("bad", "exit 3");
  batch.add("crash", "crash");
  EXPECT_EQ(batch.run().rendered, 3);
  const BatchSummary again = batch.run();
  EXPECT_EQ(again.rendered, 1) << "the crash";
  EXPECT_TRUE(MadeBatch::row(again, "well").passed());
  EXPECT_EQ(MadeBatch::row(again, "bad").kind, RowKind::kExit);
  // Another log under the same id is another job, and its time is told beside the last one's.
  batch.add("more", "ok more");
  test::spill(batch.path("well.jsonl"), "ok changed\n");
  const BatchSummary changed = batch.run();
  EXPECT_EQ(changed.rendered, 3) << "the crash, the new one and the changed one";
  EXPECT_TRUE(MadeBatch::row(changed, "well").last_wall_s.has_value());
}

TEST(Batch, TwoHashesOfOneKeyAreAnErrorOfTheirOwn) {
  MadeBatch batch;
  batch.add("same", "ok");
  batch.add("never the same", "random");
  batch.request.repeat = 3;
  const BatchSummary summary = batch.run();
  EXPECT_EQ(summary.rendered, 6);
  EXPECT_TRUE(MadeBatch::row(summary, "same").passed());
  EXPECT_EQ(MadeBatch::row(summary, "never the same").kind, RowKind::kNotDeterministic);
  batch.request.repeat = 1;
  const BatchSummary again = batch.run();
  EXPECT_EQ(again.rendered, 0);
  EXPECT_EQ(MadeBatch::row(again, "never the same").kind, RowKind::kNotDeterministic)
      << "a rerun does not hide it";
}

TEST(Batch, EachShardDoesItsPartAndTheManifestIsWhole) {
  MadeBatch batch;
  for (int i = 0; i < 12; ++i) batch.add("job " + std::to_string(i), "ok " + std::to_string(i));
  int rows = 0;
  batch.request.shards = 3;
  for (batch.request.shard = 1; batch.request.shard <= 3; ++batch.request.shard) {
    const BatchSummary summary = batch.run();
    EXPECT_LT(summary.rows.size(), 12U);
    rows += static_cast<int>(summary.rows.size());
  }
  EXPECT_EQ(rows, 12);
  const std::string manifest = test::slurp(batch.path("run/manifest.jsonl"));
  EXPECT_EQ(std::count(manifest.begin(), manifest.end(), '\n'), 12);
}

TEST(Batch, StatesAloneAreRenderedWithoutPictures) {
  MadeBatch batch;
  batch.add("well", "ok");
  batch.request.pictures = false;
  const BatchSummary states = batch.run();
  EXPECT_TRUE(MadeBatch::row(states, "well").passed());
  const std::string picture =
      batch.path("run/results/" + MadeBatch::row(states, "well").key + "/picture.png");
  EXPECT_FALSE(std::filesystem::exists(picture));
  EXPECT_EQ(batch.run().rendered, 0);
  batch.request.pictures = true;
  EXPECT_EQ(batch.run().rendered, 1) << "the picture is wanted now";
  EXPECT_TRUE(std::filesystem::exists(picture));
}

TEST(Batch, MemoryForOneAtATimeIsEnoughForAll) {
  MadeBatch batch;
  for (int i = 0; i < 4; ++i)
    batch.add("job " + std::to_string(i), "ok " + std::to_string(i), R"(,"memory_bytes":90000000)");
  batch.request.jobs = 4;
  batch.request.memory_budget = 100'000'000;
  EXPECT_EQ(batch.run().failed(), 0);
}

TEST(Batch, ASignalEndsItWithinASecondAndTheSameCommandGoesOn) {
  MadeBatch batch;
  batch.add("well", "ok");
  batch.add("hang", "hang");
  std::atomic<bool> cancelled = false;
  Control control;
  control.cancelled = &cancelled;
  control.progress = [&](const ProgressState&) { cancelled = true; };
  const auto began = std::chrono::steady_clock::now();
  const Result<BatchSummary> summary = run_batch(batch.request, control);
  ASSERT_FALSE(summary);
  EXPECT_EQ(summary.error().code, ErrorCode::kInterrupted);
  EXPECT_EQ(summary.error().message,
            "interrupted; 1 of 2 jobs are done, and the same command goes on");
  // The script needs a moment to be started; a second and a half is the signal's and that.
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::milliseconds(1500));
  std::size_t left = 0;
  for (const auto& entry : std::filesystem::directory_iterator(batch.path("run/results")))
    left += entry.path().filename().string().starts_with(".work") ? 1U : 0U;
  EXPECT_EQ(left, 0U) << "nothing half-written stays";
}

TEST(Batch, AskingForTheImpossibleIsRefused) {
  MadeBatch batch;
  batch.add("well", "ok");
  batch.request.reason = "why not";
  EXPECT_EQ(run_batch(batch.request, {}).error().code, ErrorCode::kUsage);
  batch.request.golden = batch.path("golden");
  batch.request.reason = " ";
  EXPECT_EQ(run_batch(batch.request, {}).error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace pentimento

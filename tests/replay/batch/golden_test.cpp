#include "replay/batch/golden.h"

#include <gtest/gtest.h>

#include "formats/io/sha256.h"
#include "tests/replay/batch/made_batch.h"

namespace pentimento {
namespace {

using test::MadeBatch;

class GoldenTest : public ::testing::Test {
 protected:
  GoldenTest() {
    batch.add("one", "ok 1");
    batch.add("two", "ok 2");
    batch.request.golden = batch.path("golden");
  }
  std::vector<std::string> update(const std::string& reason) {
    batch.request.reason = reason;
    const BatchSummary summary = batch.run();
    batch.request.reason.reset();
    return summary.taken;
  }
  /// Runs with another picture, in a run of its own: the script's picture is no part of the key.
  BatchSummary run_with_changed_picture(int pixel) {
    MadeBatch::write_picture(batch.path("picture.png"), pixel);
    batch.request.run = batch.path("run " + std::to_string(pixel));
    return batch.run();
  }

  MadeBatch batch;
};

TEST_F(GoldenTest, WhatHasNoGoldenResultFailsUntilItIsTaken) {
  const BatchSummary before = batch.run();
  EXPECT_EQ(MadeBatch::row(before, "one").kind, RowKind::kNoGolden);
  EXPECT_EQ(update("begun"), (std::vector<std::string>{"one", "two"}));
  EXPECT_EQ(batch.run().failed(), 0);
}

TEST_F(GoldenTest, OnlyWhatChangedIsWritten) {
  update("begun");
  const std::string index = batch.path("golden/index.jsonl");
  const auto written = std::filesystem::last_write_time(index);
  EXPECT_TRUE(update("nothing new").empty());
  EXPECT_EQ(std::filesystem::last_write_time(index), written);
  test::spill(batch.path("two.jsonl"), "ok other\n");
  EXPECT_EQ(update("two paints otherwise"), std::vector<std::string>{"two"});
  const std::string changes = test::slurp(batch.path("golden/changes.jsonl"));
  EXPECT_EQ(std::count(changes.begin(), changes.end(), '\n'), 2);
  EXPECT_NE(changes.find("two paints otherwise"), std::string::npos);
}

TEST_F(GoldenTest, AnotherStateFails) {
  update("begun");
  test::spill(batch.path("one.jsonl"), "ok changed\n");
  const BatchSummary summary = batch.run();
  EXPECT_EQ(MadeBatch::row(summary, "one").kind, RowKind::kState);
  EXPECT_TRUE(MadeBatch::row(summary, "two").passed());
}

TEST_F(GoldenTest, APixelIsEnoughToFailAndBothPicturesAreKept) {
  update("begun");
  const BatchSummary summary = run_with_changed_picture(5 * 32 + 7);
  EXPECT_EQ(summary.failed(), 2);
  const BatchRow& row = MadeBatch::row(summary, "one");
  EXPECT_EQ(row.kind, RowKind::kPicture);
  ASSERT_EQ(row.differences.size(), 3U);
  EXPECT_EQ(row.differences[0].x, 7);
  EXPECT_EQ(row.differences[0].y, 5);
  // 1 pixel of 768.
  EXPECT_NEAR(row.differences[0].share, 1.0 / 768, 1e-9);
  EXPECT_TRUE(
      std::filesystem::exists(batch.path("run 167/golden/") + row.golden_picture_sha256 + ".png"));
  // Pictures that no entry names any more go away.
  batch.request.reason = "a speck";
  EXPECT_EQ(batch.run().taken.size(), 2U);
  std::size_t pictures = 0;
  for ([[maybe_unused]] const auto& one :
       std::filesystem::directory_iterator(batch.path("golden/pictures")))
    ++pictures;
  EXPECT_EQ(pictures, 1U) << "both show the same";
}

TEST_F(GoldenTest, WhoAllowsADifferenceGetsIt) {
  update("begun");
  MadeBatch tolerant;
  tolerant.add("one", "ok changed", R"(,"expect":{"flip":0.05})");
  tolerant.add("two", "ok changed", R"(,"expect":{"flip":0.0000001})");
  tolerant.request.golden = batch.path("golden");
  MadeBatch::write_picture(tolerant.path("picture.png"), 3);
  const BatchSummary summary = tolerant.run();
  EXPECT_TRUE(MadeBatch::row(summary, "one").passed()) << "its state is not asked";
  EXPECT_EQ(MadeBatch::row(summary, "two").kind, RowKind::kPicture);
}

TEST_F(GoldenTest, APictureThatIsMissingOrAnotherFailsUntilItIsTakenAnew) {
  update("begun");
  const GoldenStore store = *GoldenStore::open(batch.path("golden"));
  const std::string picture = *store.picture(*store.find("one"));
  // Somebody put what the program shows now where what was found right should be.
  MadeBatch::write_picture(batch.path("picture.png"), 9);
  std::filesystem::copy_file(batch.path("picture.png"), picture,
                             std::filesystem::copy_options::overwrite_existing);
  batch.request.run = batch.path("after");
  const BatchSummary other = batch.run();
  EXPECT_EQ(MadeBatch::row(other, "one").kind, RowKind::kPicture);
  EXPECT_EQ(MadeBatch::row(other, "one").reasons,
            std::vector<std::string>{picture + ": not the golden picture that was taken"});
  std::filesystem::remove(picture);
  const BatchSummary missing = batch.run();
  EXPECT_EQ(MadeBatch::row(missing, "one").kind, RowKind::kPicture);
  EXPECT_NE(MadeBatch::row(missing, "one").reasons.at(0).find(picture), std::string::npos);
  // A file that has the new picture's name and is none does not stay.
  const std::string hash = sha256_hex(test::slurp(batch.path("picture.png")));
  test::spill(batch.path("golden/pictures/" + hash + ".png"), "none");
  EXPECT_EQ(update("a speck"), (std::vector<std::string>{"one", "two"}));
  const GoldenStore renewed = *GoldenStore::open(batch.path("golden"));
  EXPECT_TRUE(renewed.picture(*renewed.find("one")));
  EXPECT_EQ(batch.run().failed(), 0);
}

TEST_F(GoldenTest, AnIdIsInTheIndexOnce) {
  update("begun");
  const std::string index = batch.path("golden/index.jsonl");
  const std::string text = test::slurp(index);
  test::spill(index, text + text);
  const Result<GoldenStore> store = GoldenStore::open(batch.path("golden"));
  ASSERT_FALSE(store);
  EXPECT_NE(store.error().message.find("index.jsonl:3: a second entry of \"one\""),
            std::string::npos)
      << store.error().message;
}

TEST_F(GoldenTest, ABrokenIndexIsNamed) {
  std::filesystem::create_directories(batch.path("golden"));
  test::spill(batch.path("golden/index.jsonl"), "{\"id\":\"one\"}\n");
  const Result<GoldenStore> store = GoldenStore::open(batch.path("golden"));
  ASSERT_FALSE(store);
  EXPECT_NE(store.error().message.find("index.jsonl:1: not an entry"), std::string::npos);
}

}  // namespace
}  // namespace pentimento

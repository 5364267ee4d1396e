#include "replay/commands/dry_run.h"

#include <gtest/gtest.h>

#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

TEST(DryRun, TellsWhatTheRenderThenDoes) {
  const test::JobFolder folder;
  RenderJob job = folder.job({"a.h5", "a.png"}, {"step:40"});
  job.size.width = 160;
  job.picture.crop = {10, 20, 64, 48};
  const auto told = dry_run(job, Control());
  ASSERT_TRUE(told) << told.error().message;
  EXPECT_FALSE(std::filesystem::exists(folder.path("a.h5")));
  const JobReport done = test::rendered(job);
  EXPECT_EQ(told->steps, done.steps);
  EXPECT_EQ(told->detail, done.detail);
  EXPECT_EQ(told->log_sha256, done.log_sha256);
  ASSERT_EQ(done.outputs.size(), 2u);
  const WrittenFile& picture =
      done.outputs[0].file.ends_with("png") ? done.outputs[0] : done.outputs[1];
  EXPECT_EQ(told->size.width, picture.width);
  EXPECT_EQ(told->size.height, picture.height);
  EXPECT_EQ(told->grid.width, 80);
  EXPECT_EQ(told->grid.height, 60);
  EXPECT_GT(told->time_s, 0);
}

TEST(DryRun, JsonHasEveryMemberUnderItsName) {
  JobEstimate e;
  e.size = {320, 240, 150};
  e.grid = {80, 60, 0.4, 0.3};
  e.detail = 4;
  e.steps = 55;
  e.needs = {300'000'000, 200'000'000, 100'000'000};
  e.survey = {};
  e.survey.stamps = 7;
  e.survey.stamped_cells = 8;
  e.survey.stamped_channels = 9;
  e.survey.awake = {10, 11};
  e.survey.tilted_cell_steps = 12;
  e.survey.tiles = 13;
  e.survey.all_tiles = 14;
  e.cell_step_s = 0.5;
  e.time_s = 16.2;
  e.log_sha256 = "log";
  const std::string json = estimate_json(e);
  for (const auto& [key, value] : {std::pair{"width", "320"},
                                   {"height", "240"},
                                   {"dpi", "150"},
                                   {"grid_width", "80"},
                                   {"grid_height", "60"},
                                   {"detail", "4"},
                                   {"steps", "55"},
                                   {"stamps", "7"},
                                   {"stamped_cells", "8"},
                                   {"stamped_channels", "9"},
                                   {"awake_cell_steps", "10"},
                                   {"awake_channel_steps", "11"},
                                   {"tilted_cell_steps", "12"},
                                   {"tiles", "13"},
                                   {"all_tiles", "14"},
                                   {"memory_bytes", "300000000"},
                                   {"disk_bytes", "200000000"},
                                   {"scratch_bytes", "100000000"},
                                   {"cell_step_s", "0.5"},
                                   {"time_s", "16.2"},
                                   {"log_sha256", "log"}})
    EXPECT_EQ(test::json_member(json, key), value) << key;
  EXPECT_EQ(estimate_text(e),
            "picture  320 x 240 pixels\ngrid     80 x 60 cells, 4 times finer\n"
            "steps    55, 7 stamps\ntiles    13 of 14 with paint\nmemory   300 MB\n"
            "disk     200 MB at most, scratch 100 MB\ntime     16 s\n");
}

}  // namespace
}  // namespace pentimento

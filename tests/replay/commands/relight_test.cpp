#include "replay/commands/relight.h"

#include <gtest/gtest.h>

#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::JobFolder;

RelightJob job_of(const JobFolder& folder, const std::string& state, const std::string& picture) {
  RelightJob job;
  job.state = folder.path(state);
  job.picture.outputs = {folder.path(picture)};
  job.threads = 1;
  return job;
}

TEST(Relight, APictureOfAFinerCanvasNamesWhatTheDumpNames) {
  const JobFolder folder;
  RenderJob finer = folder.job({"a.h5"});
  finer.detail = 2;
  const JobReport made = test::rendered(finer);
  const auto report = relight(job_of(folder, "a.h5", "a.png"), Control());
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->state_sha256, made.state_sha256);
  EXPECT_EQ(report->guide_sha256, made.guide_sha256);
  EXPECT_NE(report->guide_sha256, report->state_sha256);
  EXPECT_EQ(report->log_sha256, made.log_sha256);
  EXPECT_EQ(report->detail, 2);
  for (const auto& [key, value] : {std::pair{"state_sha256", made.state_sha256},
                                   {"guide_sha256", made.guide_sha256},
                                   {"log_sha256", made.log_sha256},
                                   {"detail", std::string("2")},
                                   {"grid", std::string("80 x 60")},
                                   {"step", std::string("55")},
                                   {"time_s", std::string("1.2222222222222223")},
                                   {"picture", std::string("160 x 120")}})
    EXPECT_EQ(folder.says("a.png", key), value) << key;
}

TEST(Relight, AsksForASizeOrTakesAPixelForEachCell) {
  const JobFolder folder;
  RenderJob finer = folder.job({"a.h5"});
  finer.detail = 2;
  test::rendered(finer);
  RelightJob job = job_of(folder, "a.h5", "a.png");
  auto report = relight(job, Control());
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->outputs.front().width, 160);
  EXPECT_EQ(report->outputs.front().height, 120);
  job.size.scale = 1.5;  // times the log's grid
  report = relight(job, Control());
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->outputs.front().width, 120);
  EXPECT_EQ(report->outputs.front().height, 90);
}

TEST(Relight, EachFrameOfAPathHasItsLamp) {
  const JobFolder folder;
  test::rendered(folder.job({"a.h5"}));
  folder.write("p", "1 0 1\n-1 0 1\n");
  RelightJob job = job_of(folder, "a.h5", "f-%d.png");
  job.light_path = folder.path("p");
  job.frames = 2;
  const auto report = relight(job, Control());
  ASSERT_TRUE(report) << report.error().message;
  ASSERT_EQ(report->outputs.size(), 2u);
  // 1/sqrt(2), in the shortest digits of float.
  EXPECT_EQ(folder.says("f-0.png", "light.direction"), "0.70710677 0 0.70710677");
  EXPECT_EQ(folder.says("f-1.png", "light.direction"), "-0.70710677 0 0.70710677");
}

}  // namespace
}  // namespace pentimento

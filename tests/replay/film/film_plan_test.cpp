#include "replay/film/film_plan.h"

#include <gtest/gtest.h>

#include "formats/image/read_image.h"
#include "formats/video/video_reader.h"
#include "tests/replay/small_job.h"

namespace pentimento {
namespace {

using test::JobFolder;
using test::rendered;

bool same_pixels(const std::string& a, const std::string& b) {
  const Result<Image> one = read_image(a), other = read_image(b);
  if (!one || !other || one->width != other->width || one->height != other->height) return false;
  for (std::size_t c = 0; c < one->plane.size(); ++c)
    for (int y = 0; y < one->height; ++y)
      for (int x = 0; x < one->width; ++x)
        if (one->plane[c](x, y) != other->plane[c](x, y)) return false;
  return true;
}

TEST(Film, AFrameIsThePictureOfItsStepBitForBit) {
  const JobFolder folder;
  for (const int detail : {1, 2}) {
    RenderJob film = folder.job({"f-%02d.png", "film.avi", "end.png", "end.h5"});
    film.film.frames = 6;
    film.detail = detail;
    const JobReport report = rendered(film);
    ASSERT_EQ(report.frame_steps.size(), 6U);
    for (const std::size_t i : {0U, 3U, 5U}) {
      RenderJob one = folder.job({"one.png"}, {"step:" + std::to_string(report.frame_steps[i])});
      one.detail = detail;
      rendered(one);
      EXPECT_TRUE(
          same_pixels(folder.path("f-0" + std::to_string(i) + ".png"), folder.path("one.png")))
          << i << " at detail " << detail;
    }
    EXPECT_TRUE(same_pixels(folder.path("f-05.png"), folder.path("end.png")));
    EXPECT_FALSE(same_pixels(folder.path("f-00.png"), folder.path("end.png")));
    EXPECT_EQ(folder.says("end.h5", "state_sha256"), report.state_sha256);
  }
}

TEST(Film, AVideoHasEveryFrameInItsSize) {
  const JobFolder folder;
  RenderJob job = folder.job({"film.avi"});
  job.film.length_s = 0.4;
  job.picture.frames_per_second = job.film.frames_per_second = 25;
  job.size.width = 120;
  EXPECT_EQ(rendered(job).frame_steps.size(), 10U);
  Result<std::unique_ptr<VideoReader>> video = VideoReader::open(folder.path("film.avi"));
  ASSERT_TRUE(video) << video.error().message;
  const auto first = (*video)->frame_at(0), last = (*video)->frame_at(9.4 / 25);
  ASSERT_TRUE(first && last);
  EXPECT_EQ((*last)[0].width(), 120);
  EXPECT_EQ((*last)[0].height(), 90);
  // The second stroke, which is yellow, passes here: paper and yellow differ most in their blue.
  EXPECT_GT((*first)[2](63, 69), 0.5f);
  EXPECT_LT((*last)[2](63, 69), 0.25f);
}

TEST(Film, RefusesWhatDoesNotGoTogether) {
  const JobFolder folder;
  const auto problem = [](RenderJob job) {
    const Result<JobReport> done = render(job, {});
    return done ? std::string() : done.error().message;
  };
  RenderJob job = folder.job({"film.avi"}, {"0.5"});
  EXPECT_EQ(problem(job), "--at: a film has frames of its own");
  job = folder.job({"film.avi"});
  job.settle_s = 1;
  EXPECT_EQ(problem(job), "--settle does not go with a film");
  job = folder.job({"film.avi"});
  job.film.frames = 3;
  job.film.length_s = 3;
  EXPECT_EQ(problem(job), "--frames and --length both say how long the film is");
  job = folder.job({"end.png"});
  job.film.frames = 3;
  EXPECT_NE(problem(job).find("--frames and --length need an -o"), std::string::npos);
  job = folder.job({"f-%.png"});
  job.film.frames = 3;
  EXPECT_NE(problem(job).find("numbered frames need one %d"), std::string::npos);
}

}  // namespace
}  // namespace pentimento

#include <gtest/gtest.h>

#include <cmath>

#include "core/optics/srgb.h"
#include "formats/video/video_reader.h"
#include "formats/video/video_writer.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;
using test::slurp;
using test::spill;

constexpr int kWidth = 48, kHeight = 32;

/// One frame of one grey, in two strips.
Result<void> write_grey(PictureFile& video, float grey) {
  Field<float> plane(kWidth, kHeight / 2, grey);
  for (const int y0 : {0, kHeight / 2}) {
    Result<void> written =
        video.write({y0, kHeight / 2, {"R", "G", "B"}, {plane.view(), plane.view(), plane.view()}});
    if (!written) return written;
  }
  return {};
}

/// Frame i has the code 40 i + 20; two frames a second.
Result<void> make_film(const std::string& path, int frames) {
  VideoOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.frames_per_second = 2;
  auto video = create_video(path, options);
  if (!video) return video.error();
  for (int i = 0; i < frames; ++i) {
    const auto grey = static_cast<float>(srgb_to_linear((40.0 * i + 20) / 255));
    if (Result<void> written = write_grey(**video, grey); !written) return written;
  }
  Result<Published> done = (*video)->finish();
  return done ? Result<void>() : Result<void>(done.error());
}

int frame_shown(VideoReader& video, double time_s) {
  const auto rgb = video.frame_at(time_s);
  if (!rgb) return -1;
  EXPECT_EQ((*rgb)[0].width(), kWidth);
  EXPECT_EQ((*rgb)[0].height(), kHeight);
  const double code = linear_to_srgb(static_cast<double>((*rgb)[1](20, 10))) * 255;
  const int frame = static_cast<int>(std::lround((code - 20) / 40));
  // What the encoders lose of an even grey: a few codes, far less than the 40 between frames.
  EXPECT_NEAR(code, 40 * frame + 20, 6);
  return frame;
}

class VideoKind : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Extensions, VideoKind, testing::Values("a.avi", "a.mp4", "a.MKV"));

TEST_P(VideoKind, HoldsItsFramesInOrderAndAtTheirTimes) {
  const Scratch scratch;
  const std::string path = scratch.path(GetParam());
  ASSERT_TRUE(is_video_name(path));
  const Result<void> made = make_film(path, 5);
  ASSERT_TRUE(made.ok()) << made.error().message;
  EXPECT_EQ(scratch.files(), 1u);  // no temporary
  EXPECT_TRUE(is_video(path));
  auto video = VideoReader::open(path);
  ASSERT_TRUE(video.ok()) << video.error().message;
  EXPECT_EQ(frame_shown(**video, 0), 0);
  EXPECT_EQ(frame_shown(**video, 0.49), 0);
  EXPECT_EQ(frame_shown(**video, 0.5), 1);
  EXPECT_EQ(frame_shown(**video, 1.9), 3);
  EXPECT_EQ(frame_shown(**video, 0.7), 1);  // back
  EXPECT_EQ(frame_shown(**video, 99), 4);   // the last stays
  EXPECT_EQ(frame_shown(**video, 99), 4);
}

TEST(VideoTest, ThatIsNotEndedLeavesNothingAndAnOldOneAsItWas) {
  const Scratch scratch;
  const std::string path = scratch.path("a.avi");
  spill(path, "old");
  {
    VideoOptions options;
    options.width = kWidth;
    options.height = kHeight;
    auto video = create_video(path, options);
    ASSERT_TRUE(video.ok());
    ASSERT_TRUE(write_grey(**video, 0.5f).ok());
    EXPECT_EQ(scratch.files(), 3u);  // the old one, the film so far, its place
    EXPECT_EQ(write_grey(**video, std::nanf("")).error().code, ErrorCode::kNonFinite);
  }
  EXPECT_EQ(scratch.files(), 1u);
  EXPECT_EQ(slurp(path), "old");
  VideoOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.no_clobber = true;
  EXPECT_EQ(create_video(path, options).error().code, ErrorCode::kIo);
  EXPECT_EQ(create_video(scratch.path("nowhere/a.mp4"), options).error().code, ErrorCode::kIo);
  options.width = 47;
  EXPECT_EQ(create_video(scratch.path("b.mp4"), options).error().code, ErrorCode::kUsage);
  EXPECT_EQ(scratch.files(), 1u);
}

// FFmpeg prints several lines about each of these.
TEST(Video, NothingIsPrintedAboutABrokenOne) {
  const Scratch scratch;
  ASSERT_TRUE(make_film(scratch.path("whole.mkv"), 5).ok());
  const std::string whole = slurp(scratch.path("whole.mkv")), path = scratch.path("a.mkv");
  std::string damaged = whole;
  damaged.replace(whole.size() / 2, 40, 40, '\0');
  for (const std::string& bytes : {whole.substr(0, whole.size() / 2), damaged}) {
    spill(path, bytes);
    testing::internal::CaptureStderr();
    auto video = VideoReader::open(path);
    if (video) static_cast<void>((*video)->frame_at(9));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(video || video.error().message.starts_with(path + ": "));
  }
}

TEST(Video, IsToldFromOtherFilesAndABrokenOneIsAnError) {
  const Scratch scratch;
  spill(scratch.path("a.avi"), "no video at all, only its name");
  EXPECT_FALSE(is_video(scratch.path("a.avi")));
  EXPECT_FALSE(is_video(scratch.path("none")));
  spill(scratch.path("b.mp4"), std::string("\0\0\0\x18"
                                           "ftypmp42",
                                           12) +
                                   std::string(200, 'x'));
  EXPECT_TRUE(is_video(scratch.path("b.mp4")));
  const auto broken = VideoReader::open(scratch.path("b.mp4"));
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().code, ErrorCode::kBadInput);
  ASSERT_TRUE(make_film(scratch.path("c.avi"), 1).ok());
  EXPECT_EQ(VideoReader::open(scratch.path("c.avi"), {16, 1 << 20}).error().code,
            ErrorCode::kLimit);
}

}  // namespace
}  // namespace pentimento

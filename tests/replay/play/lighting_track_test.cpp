#include "replay/play/lighting_track.h"

#include <gtest/gtest.h>

#include <cmath>

#include "formats/video/video_writer.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

/// A track in a folder that has a video of four frames a second; frame i has the light i / 8.
struct Track {
  test::Scratch scratch;
  LogFiles files{scratch.path("log.jsonl"), false};
  LightingTrack track{Lighting(), 45};

  void follow(const log::Action& action, std::int64_t step = 0) {
    const Result<void> followed = track.follow(action, step, files);
    EXPECT_TRUE(followed) << followed.error().message;
  }
  const Lamp& lamp(std::size_t i) const { return track.lighting().lamps.at(i); }
  void make_video() const {
    VideoOptions options;
    options.width = 32;
    options.height = 18;
    options.frames_per_second = 4;
    auto film = create_video(scratch.path("v.avi"), options);
    ASSERT_TRUE(film) << film.error().message;
    for (int i = 0; i < 8; ++i) {
      const Field<float> plane(32, 18, static_cast<float>(i) / 8);
      ASSERT_TRUE(
          (*film)->write({0, 18, {"R", "G", "B"}, {plane.view(), plane.view(), plane.view()}}));
    }
    ASSERT_TRUE((*film)->finish());
  }
  int frame_after(std::int64_t steps) {
    EXPECT_TRUE(track.look(steps));
    return static_cast<int>(std::lround(track.lighting().reflection.rgb[1](16, 9) * 8));
  }
};

log::Light light(int lamp) {
  log::Light event;
  event.lamp = lamp;
  return event;
}

TEST(LightingTrack, AVideoIsTimedFromItsEvent) {
  Track t;
  t.make_video();
  log::Camera camera;
  camera.file = "v.avi";
  t.follow(camera, 90);
  EXPECT_EQ(t.frame_after(91), 0);
  EXPECT_EQ(t.frame_after(90 + 12), 1);  // 12/45 s = 0.27 s
  EXPECT_EQ(t.frame_after(90 + 45), 4);
  camera.start_s = 0.5;
  t.follow(camera, 180);
  EXPECT_EQ(t.frame_after(181), 2);
  EXPECT_EQ(t.frame_after(180 + 45), 6);
}

TEST(LightingTrack, ACameraIsAsItsEventSays) {
  Track t;
  t.make_video();
  log::Camera camera;
  camera.file = "v.avi";
  camera.fov_deg = 75;
  camera.mirror = false;
  t.follow(camera);
  EXPECT_EQ(t.track.lighting().reflection.fov_deg, 75);
  EXPECT_FALSE(t.track.lighting().reflection.mirror);
}

TEST(LightingTrack, LampsBetweenThatNobodySpokeOfAreDark) {
  Track t;
  t.follow(light(2));
  ASSERT_EQ(t.track.lighting().lamps.size(), 3u);
  EXPECT_EQ(t.lamp(0), Lamp{});
  EXPECT_EQ(t.lamp(1).intensity, 0);
  EXPECT_EQ(t.lamp(2).intensity, Lamp{}.intensity);  // a new one begins as the default
  log::Light dark = light(2);
  dark.direction = {1, 0, 0};
  dark.intensity = 0;
  t.follow(dark);
  log::Light turned = light(2);
  turned.direction = {0, 3, 4};
  t.follow(turned);
  EXPECT_EQ(t.lamp(2).intensity, 0);  // it was spoken of
  EXPECT_EQ(t.lamp(2).direction, (std::array<float, 3>{0, 0.6f, 0.8f}));
}

TEST(LightingTrack, ADirectionTakesAPositionsPlaceAndBothEndFollowing) {
  Track t;
  log::Light near = light(0);
  near.position_m = {0.1, 0.2, 0.5};
  near.color = {0.5, 0.25, 0.125};
  near.follow_gravity = true;
  t.follow(near);
  ASSERT_TRUE(t.lamp(0).position_m);
  EXPECT_EQ(*t.lamp(0).position_m, (std::array<float, 3>{0.1f, 0.2f, 0.5f}));
  EXPECT_EQ(t.lamp(0).color, (std::array<float, 3>{0.5f, 0.25f, 0.125f}));
  EXPECT_TRUE(t.lamp(0).follows_gravity);
  log::Light brighter = light(0);
  brighter.intensity = 0.25;
  t.follow(brighter);
  EXPECT_TRUE(t.lamp(0).follows_gravity);  // not a word of where it is
  EXPECT_EQ(t.lamp(0).intensity, 0.25f);
  log::Light far = light(0);
  far.direction = {0, 0, 2};
  t.follow(far);
  EXPECT_FALSE(t.lamp(0).position_m);
  EXPECT_FALSE(t.lamp(0).follows_gravity);
  EXPECT_EQ(t.lamp(0).direction, (std::array<float, 3>{0, 0, 1}));
}

TEST(LightingTrack, GravityIsTheLastReading) {
  Track t;
  t.follow(log::Gravity{1, 2, 3});
  t.follow(log::Gravity{4, 5, 6});
  EXPECT_EQ(t.track.gravity().x_m_s2, 4);
  EXPECT_EQ(t.track.gravity().y_m_s2, 5);
  EXPECT_EQ(t.track.gravity().z_m_s2, 6);
}

TEST(LightingTrack, NineCoefficientsTakeAProbesPlace) {
  Lighting start;
  for (Field<float>& plane : start.probe) plane = Field<float>(4, 2, 1.0f);
  LightingTrack track(std::move(start), 45);
  LogFiles files("-", false);
  log::Environment around;
  around.sh.emplace();
  for (std::size_t i = 0; i < 9; ++i)
    (*around.sh)[i] = {0.1 * static_cast<double>(i), 0.2, 0.3 * static_cast<double>(i)};
  ASSERT_TRUE(track.follow(around, 0, files));
  for (std::size_t i = 0; i < 9; ++i) {
    const auto n = static_cast<double>(i);
    EXPECT_EQ(
        track.lighting().environment.L[i],
        (std::array<float, 3>{static_cast<float>(0.1 * n), 0.2f, static_cast<float>(0.3 * n)}));
  }
  EXPECT_TRUE(track.lighting().probe[0].empty());
}

TEST(LightByPanorama, ASoftOneTakesTheProbeOfTheOneBeforeAway) {
  Lighting lighting;
  const std::string studio = PENTIMENTO_TEST_DATA "/probes/studio.hdr";
  ASSERT_TRUE(light_by_panorama(studio, false, lighting));
  EXPECT_FALSE(lighting.probe[0].empty());
  ASSERT_TRUE(light_by_panorama(studio, true, lighting));
  for (const Field<float>& plane : lighting.probe) EXPECT_TRUE(plane.empty());
}

TEST(Develop, TakesWhatIsSaidAndLeavesTheRest) {
  Lighting lighting;
  develop({}, lighting);
  EXPECT_EQ(lighting.exposure_ev, 0);
  EXPECT_EQ(lighting.occlusion, 1);
  EXPECT_EQ(lighting.white_xy, kD65_xy);
  log::PictureSpec said;
  said.exposure_ev = -1.5;
  said.varnish = 0.25;
  said.occlusion = 0.5;
  said.white_xy = {0.35, 0.36};
  said.tone = ToneCurve::kFilmic;
  develop(said, lighting);
  EXPECT_EQ(lighting.exposure_ev, -1.5f);
  EXPECT_EQ(lighting.varnish, 0.25f);
  EXPECT_EQ(lighting.occlusion, 0.5f);
  EXPECT_EQ(lighting.white_xy, (std::array<float, 2>{0.35f, 0.36f}));
  EXPECT_EQ(lighting.tone, ToneCurve::kFilmic);
}

TEST(SettleLamp, TurnsDirectionAndPlaceForGood) {
  // Upright: z turns into y and y into -z.
  Lamp lamp;
  lamp.direction = {0.6f, 0, 0.8f};
  lamp.position_m = {0.1f, 0.2f, 0.5f};
  lamp.follows_gravity = true;
  fix_lamp(lamp, {0, 9.81, 0});
  EXPECT_NEAR(lamp.direction[0], 0.6f, 1e-6f);  // rounding of float here and below
  EXPECT_NEAR(lamp.direction[1], 0.8f, 1e-6f);
  EXPECT_NEAR(lamp.direction[2], 0.0f, 1e-6f);
  ASSERT_TRUE(lamp.position_m);
  EXPECT_NEAR((*lamp.position_m)[0], 0.1f, 1e-6f);
  EXPECT_NEAR((*lamp.position_m)[1], 0.5f, 1e-6f);
  EXPECT_NEAR((*lamp.position_m)[2], -0.2f, 1e-6f);
  EXPECT_FALSE(lamp.follows_gravity);
}

}  // namespace
}  // namespace pentimento

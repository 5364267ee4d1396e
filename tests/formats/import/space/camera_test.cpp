#include "formats/import/space/camera.h"

#include <gtest/gtest.h>

namespace pentimento::sketch {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

SpaceStroke stroke_at(std::vector<Vector3d> places, double width = 0.1) {
  SpaceStroke out;
  out.stroke.timed = true;
  out.stroke.width = width;
  for (std::size_t i = 0; i < places.size(); ++i)
    out.stroke.samples.push_back({.time_s = 100 + static_cast<double>(i)});
  out.places = std::move(places);
  return out;
}
/// At (0, 0, 10), looking along -z.
PinholeCamera looking_back() {
  PinholeCamera out;
  out.eye = {0, 0, 10};
  return out;
}

TEST(SpaceCamera, WhatIsFartherIsSmaller) {
  const PinholeCamera camera = looking_back();
  EXPECT_TRUE(camera({1, 2, 0}).isApprox(Vector2d(0.1, -0.2)));
  EXPECT_TRUE(camera({1, 2, 5}).isApprox(Vector2d(0.2, -0.4)));
  EXPECT_DOUBLE_EQ(camera.depth({3, -1, 4}), 6);
  const Sight sight = see(std::vector{stroke_at({{0, 0, 0}, {1, 0, 0}}, 0.5)}, camera);
  ASSERT_EQ(sight.strokes.size(), 1u);
  EXPECT_DOUBLE_EQ(sight.strokes[0].width, 0.05);
  EXPECT_DOUBLE_EQ(sight.strokes[0].samples[1].x, 0.1);
  EXPECT_EQ(sight.unseen_points, 0);
}

TEST(SpaceCamera, ThePictureIsAsWideAsItsAspectSays) {
  PinholeCamera camera;
  camera.half_height = 0.5;
  camera.aspect = 2;
  const Page page = camera.page();
  EXPECT_DOUBLE_EQ(page.x, -1);
  EXPECT_DOUBLE_EQ(page.y, -0.5);
  EXPECT_DOUBLE_EQ(page.width, 2);
  EXPECT_DOUBLE_EQ(page.height, 1);
}

TEST(SpaceCamera, PaintsFromBackToFrontOneAfterAnother) {
  const Sight sight = see(std::vector{stroke_at({{0, 0, 5}, {0.5, 0, 5}}), stroke_at({{0.1, 0, 0}}),
                                      stroke_at({{0.2, 0, 7}, {0.2, 0, 7}, {0.2, 0, 7}})},
                          looking_back());
  ASSERT_EQ(sight.strokes.size(), 3u);
  EXPECT_DOUBLE_EQ(sight.strokes[0].samples[0].x, 0.01);
  EXPECT_EQ(sight.strokes[1].samples.size(), 2u);
  EXPECT_EQ(sight.strokes[2].samples.size(), 3u);
  EXPECT_NEAR(sight.strokes[0].samples[0].time_s, 0, 1e-9);
  EXPECT_NEAR(sight.strokes[1].samples[0].time_s, 0.2, 1e-9);
  EXPECT_NEAR(sight.strokes[1].samples[1].time_s, 1.2, 1e-9);
  EXPECT_NEAR(sight.strokes[2].samples[0].time_s, 1.4, 1e-9);
}

TEST(SpaceCamera, PartsAStrokeWhereItIsNotSeen) {
  // The picture reaches 1 to each side, strokes 2; behind the eye nothing is seen.
  const Sight sight = see(std::vector{stroke_at({{0, 0, 0},
                                                 {19, 0, 0},
                                                 {21, 0, 0},
                                                 {0, -21, 0},
                                                 {0, -19, 0},
                                                 {0, 0, 11},
                                                 {0, 0, 9.95},
                                                 {0, 0, 9.8}})},
                          looking_back());
  EXPECT_EQ(sight.unseen_points, 4);
  ASSERT_EQ(sight.strokes.size(), 3u);
  EXPECT_EQ(sight.strokes[0].samples.size(), 2u);
  EXPECT_EQ(sight.strokes[1].samples.size(), 1u);
  EXPECT_DOUBLE_EQ(sight.strokes[1].samples[0].y, 1.9);
  EXPECT_EQ(sight.strokes[2].samples.size(), 1u);
}

TEST(SpaceCamera, LeavesATwinOutThatLiesOnItsPartner) {
  SpaceStroke twin = stroke_at({{0, 0, 1}, {1.05, 0, 0}});
  twin.twin = true;
  const SpaceStroke partner = stroke_at({{0, 0, 0}, {1, 0, 0}});
  EXPECT_EQ(see(std::vector{partner, twin}, looking_back()).merged_twins, 1);
  EXPECT_EQ(see(std::vector{partner, twin}, looking_back()).strokes.size(), 1u);
  twin.places[1].x() = 1.2;  // farther than the width of 0.1
  EXPECT_EQ(see(std::vector{partner, twin}, looking_back()).merged_twins, 0);
  twin.places[1].x() = 1.05;
  twin.twin = false;  // another stroke, that only lies there
  EXPECT_EQ(see(std::vector{partner, twin}, looking_back()).strokes.size(), 2u);
}

}  // namespace
}  // namespace pentimento::sketch

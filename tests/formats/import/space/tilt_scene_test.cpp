#include "formats/import/space/tilt_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/optics/srgb.h"

namespace pentimento::sketch {
namespace {

using Eigen::Vector3d;

std::string error_of(const std::string& json) {
  const auto scene = read_tilt_scene("in", json);
  return scene ? "none" : scene.error().message;
}

TEST(TiltScene, ReadsBrushesTitleAndSky) {
  const auto scene = read_tilt_scene("in", R"({"BrushIndex":
      ["f72ec0e7-a844-4e38-82e3-140c44772699", "11111111-0000-0000-0000-000000000000"],
      "Environment":{"GradientColors":[[255,0,0,255],[255,255,0,255]]},
      "Name":"Bird","Authors":["A","B"]})");
  ASSERT_TRUE(scene) << scene.error().message;
  ASSERT_EQ(scene->brushes.size(), 2u);
  EXPECT_EQ(scene->brushes[0].name, "Oil Paint");
  EXPECT_EQ(scene->brushes[1].name, "") << "not known";
  EXPECT_FALSE(scene->brushes[1].width_share_unpressed);
  EXPECT_FALSE(scene->camera);
  ASSERT_TRUE(scene->background);
  EXPECT_EQ(*scene->background, (log::Rgb{1, 0.5, 0}));
  EXPECT_EQ(scene->title, "Bird");
  EXPECT_EQ(scene->author, "A, B");
}

TEST(TiltScene, SeesTheSceneAsItsCameraStandsInTheRoom) {
  // The scene is at half its size, 10 dm ahead of the room's middle, turned by 90 degrees about y:
  // its x points along the room's -z (left-handed). The camera is at the room's middle.
  const auto scene = read_tilt_scene("in", R"({"BrushIndex":[],
      "SceneTransformInRoomSpace":[[0,0,10],[0,0.7071067811865476,0,0.7071067811865476],0.5],
      "ThumbnailCameraTransformInRoomSpace":[[0,0,0],[0,0,0,2],1]})");
  ASSERT_TRUE(scene);
  ASSERT_TRUE(scene->camera);
  const PinholeCamera& camera = *scene->camera;
  // Its eye is 20 dm from the scene's origin, on the side of x; right-handed, z is turned round.
  EXPECT_TRUE(camera.eye.isApprox(Vector3d(20, 0, 0), 1e-12)) << camera.eye.transpose();
  EXPECT_TRUE(camera.forward.isApprox(Vector3d(-1, 0, 0), 1e-12)) << camera.forward.transpose();
  EXPECT_TRUE(camera.up.isApprox(Vector3d(0, 1, 0), 1e-12));
  EXPECT_TRUE(camera.forward.isApprox(camera.up.cross(camera.right), 1e-12)) << "right-handed";
  EXPECT_NEAR(camera.half_height, 0.8391, 1e-4) << "80 degrees from top to bottom";
}

TEST(TiltScene, TakesNoCameraThatCannotBe) {
  for (const char* placing : {"null", "[[0,0,0],[0,0,0,0],1]", "[[0,0],[0,0,0,1],1]",
                              "[[0,0,1e300],[0,0,0,1],1]", "[[0,0,0],[0,0,0,1],0]", "[1,2,3]"}) {
    const auto scene =
        read_tilt_scene("in", R"({"BrushIndex":[],"ThumbnailCameraTransformInRoomSpace":)" +
                                  std::string(placing) + "}");
    ASSERT_TRUE(scene) << placing;
    EXPECT_FALSE(scene->camera) << placing;
  }
}

TEST(TiltScene, RefusesWhatIsNoScene) {
  EXPECT_TRUE(error_of("{").starts_with("in: metadata.json: not valid JSON: ")) << error_of("{");
  EXPECT_EQ(error_of("{}"), "in: metadata.json: BrushIndex is missing");
  EXPECT_EQ(error_of("[]"), "in: metadata.json: BrushIndex is missing");
  EXPECT_EQ(error_of(R"({"BrushIndex":[7]})"), "in: metadata.json: a brush is no text");
  std::string many = R"({"BrushIndex":[0)";
  for (int i = 0; i < 10000; ++i) many += ",0";
  EXPECT_EQ(error_of(many + "]}"), "in: metadata.json: 10001 brushes are over 10000");
}

}  // namespace
}  // namespace pentimento::sketch

#include "replay/output/aov_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/reference/made_up_canvas.h"
#include "tests/reference/whole_picture.h"

namespace pentimento {
namespace {

ChannelBasis two_channels() {
  ChannelBasis basis;
  basis.name = {"a", "b/c"};
  basis.amount = Eigen::VectorXf::Ones(2);
  return basis;
}

const reference::MadeUpCanvas& canvas() {
  static const reference::MadeUpCanvas made({160, 120, 0.16, 0.12}, 2, 2);
  return made;
}

const AovPicture* find(const std::vector<AovPicture>& pictures, const std::string& name) {
  const auto at = std::find_if(pictures.begin(), pictures.end(),
                               [&](const AovPicture& p) { return p.name == name; });
  return at == pictures.end() ? nullptr : &*at;
}

TEST(AovPictures, AreOneAGroupAndOneAPigment) {
  const auto pictures =
      aov_pictures({"albedo", "depth", "pigment"}, canvas(), two_channels(), false);
  ASSERT_TRUE(pictures.ok());
  ASSERT_EQ(pictures->size(), 4u);
  EXPECT_EQ((*pictures)[0].planes, (std::vector<std::string>{"albedo.R", "albedo.G", "albedo.B"}));
  EXPECT_FALSE((*pictures)[0].scale);  // light
  EXPECT_EQ((*pictures)[1].planes, (std::vector<std::string>{"depth.Y"}));
  EXPECT_EQ((*pictures)[3].name, "pigment.b/c");
  EXPECT_FALSE(aov_pictures({"blue"}, canvas(), two_channels(), false).ok());
}

TEST(AovPictures, ScalesHoldEveryValueOfTheCanvas) {
  const auto pictures =
      aov_pictures({"height", "depth", "pigment"}, canvas(), two_channels(), false);
  ASSERT_TRUE(pictures.ok());
  float least = 1e9f, most = -1e9f, deepest = 0, pigment = 0;
  for (int y = 0; y < 120; ++y) {
    for (int x = 0; x < 160; ++x) {
      const float depth = canvas().value({PlaneKind::kDepth}, x, y);
      const float height = canvas().value({PlaneKind::kBase}, x, y) + depth;
      least = std::min(least, height);
      most = std::max(most, height);
      deepest = std::max(deepest, depth);
      pigment = std::max(pigment, canvas().value(pigment_plane(0, 1), x, y) +
                                      canvas().value(pigment_plane(1, 1), x, y));
    }
  }
  const auto end = [](const AovPicture& p) { return p.scale->offset + 65535 * p.scale->per_code; };
  const AovPicture &height = *find(*pictures, "height"), &depth = *find(*pictures, "depth");
  EXPECT_FLOAT_EQ(static_cast<float>(height.scale->offset), least);
  EXPECT_FLOAT_EQ(static_cast<float>(end(height)), most);
  EXPECT_EQ(depth.scale->offset, 0);
  EXPECT_FLOAT_EQ(static_cast<float>(end(depth)), deepest);
  EXPECT_EQ(depth.unit, "m");
  EXPECT_FLOAT_EQ(static_cast<float>(end(*find(*pictures, "pigment.b/c"))), pigment);
}

TEST(AovPictures, BetweenCellsTheSurfaceMayRiseAboveThem) {
  const auto cells = aov_pictures({"height"}, canvas(), two_channels(), false);
  const auto finer = aov_pictures({"height"}, canvas(), two_channels(), true);
  const NumberScale &a = *cells->front().scale, &b = *finer->front().scale;
  EXPECT_LT(b.offset, a.offset);
  EXPECT_GT(b.offset + 65535 * b.per_code, a.offset + 65535 * a.per_code);
}

TEST(AovPath, StandsBesideThePictureUnderASafeName) {
  EXPECT_EQ(aov_path("out.png", "depth"), "out.depth.png");
  EXPECT_EQ(aov_path("a.b/out.v2.PNG", "normal"), "a.b/out.v2.normal.PNG");
  EXPECT_EQ(aov_path("out.png", "pigment.../x y#1"), "out.pigment..._x_y_1.png");
}

TEST(PlaneSink, HandsOnTheNamedPlanesInOrder) {
  reference::WholePicture whole;
  PlaneSink sink(whole, {"Y", "R"});
  Field<float> r(2, 1, 1.0f), g(2, 1, 2.0f), y(2, 1, 3.0f);
  PictureStrip strip{0, 1, {"R", "G", "Y"}, {r.view(), g.view(), y.view()}};
  ASSERT_TRUE(sink.write(strip).ok());
  EXPECT_EQ(whole.planes.size(), 2u);
  EXPECT_EQ(whole.at("Y", 1, 0), 3);
  EXPECT_EQ(whole.at("R", 0, 0), 1);
}

}  // namespace
}  // namespace pentimento

#include "replay/compare/compare.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "formats/exr/exr_writer.h"
#include "formats/png/png_writer.h"
#include "replay/compare/plane_difference.h"
#include "tests/formats/hdf5/made_up_dump.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;
const std::vector<std::string> kRgb = {"R", "G", "B"};

void write_png(const std::string& path, const std::vector<Field<float>>& planes) {
  PngOptions options;
  options.width = planes[0].width();
  options.height = planes[0].height();
  auto file = create_png(path, options);
  ASSERT_TRUE(file);
  ASSERT_TRUE(test::write_strips(**file, planes, kRgb, 16));
  ASSERT_TRUE((*file)->finish());
}

void write_exr(const std::string& path, const std::vector<Field<float>>& planes) {
  ExrOptions options;
  options.width = planes[0].width();
  options.height = planes[0].height();
  options.channels = kRgb;
  options.full_float = true;
  auto file = create_exr(path, options);
  ASSERT_TRUE(file);
  ASSERT_TRUE(test::write_strips(**file, planes, kRgb, 16));
  ASSERT_TRUE((*file)->finish());
}

Result<Comparison> compare(const std::string& a, const std::string& b,
                           const CompareThresholds& thresholds = {}) {
  return compare_files(a, b, thresholds, Threads(1));
}

TEST(PlaneDifference, IsThatOfTheDefinition) {
  Field<float> a(4, 1), b(4, 1);
  b(1, 0) = 0.5f;
  b(3, 0) = -0.25f;
  const PlaneDifference d = plane_difference("x", a.view(), b.view(), 1);
  EXPECT_EQ(d.max, 0.5);
  EXPECT_EQ(d.max_x, 1);
  EXPECT_EQ(d.max_y, 0);
  EXPECT_DOUBLE_EQ(d.rms, std::sqrt((0.25 + 0.0625) / 4));
  EXPECT_DOUBLE_EQ(d.psnr_db, -20 * std::log10(d.rms));
  EXPECT_EQ(d.differing, 0.5);
}

TEST(PlaneDifference, NanEqualsNanAndNothingElse) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Field<float> a(2, 1, nan), b(2, 1, nan);
  EXPECT_EQ(plane_difference("x", a.view(), b.view(), 1).differing, 0);
  b(1, 0) = 0;
  const PlaneDifference d = plane_difference("x", a.view(), b.view(), 1);
  EXPECT_EQ(d.differing, 0.5);
  EXPECT_TRUE(std::isinf(d.max));
}

TEST(Compare, EqualPicturesAreEqual) {
  const Scratch scratch;
  const auto planes = test::made_up_planes(40, 30, 3);
  write_png(scratch.path("a.png"), planes);
  write_png(scratch.path("b.png"), planes);
  const auto result = compare(scratch.path("a.png"), scratch.path("b.png"));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result->equal);
  EXPECT_EQ(result->planes.size(), 3u);
  EXPECT_EQ(*result->flip_mean, 0);
  EXPECT_NE(comparison_text(*result).find("\nequal\n"), std::string::npos);
}

TEST(Compare, OneCodeInOnePixelIsADifferenceUnlessAllowed) {
  const Scratch scratch;
  auto planes = test::made_up_planes(40, 30, 3);
  planes[1](7, 9) = 0.5f;
  write_png(scratch.path("a.png"), planes);
  planes[1](7, 9) = 0.51f;  // sRGB 187.5 and 189.2
  write_png(scratch.path("b.png"), planes);
  const auto strict = compare(scratch.path("a.png"), scratch.path("b.png"));
  ASSERT_TRUE(strict);
  EXPECT_FALSE(strict->equal);
  const PlaneDifference& green = strict->planes[1];
  // One code of 255; the curve there and back is good to single precision.
  EXPECT_NEAR(green.max, 1.0 / 255, 1e-6);
  EXPECT_EQ(green.max_x, 7);
  EXPECT_EQ(green.max_y, 9);
  EXPECT_DOUBLE_EQ(green.differing, 1.0 / 1200);
  EXPECT_EQ(strict->planes[0].differing, 0);
  CompareThresholds loose;
  loose.max = 1.01 / 255;
  loose.flip = 0.01;
  EXPECT_TRUE(compare(scratch.path("a.png"), scratch.path("b.png"), loose)->equal);
  loose.differing = 0.0001;
  EXPECT_FALSE(compare(scratch.path("a.png"), scratch.path("b.png"), loose)->equal);
}

TEST(Compare, EachThresholdDecides) {
  Comparison c;
  PlaneDifference d;
  d.max = 0.1;
  d.rms = 0.01;
  d.psnr_db = 40;
  d.differing = 0.5;
  c.planes = {d};
  c.flip_mean = 0.05;
  const auto equal = [&](CompareThresholds t) {
    decide(c, t);
    return c.equal;
  };
  EXPECT_FALSE(equal({}));
  EXPECT_TRUE(equal({.max = 0.1}));
  EXPECT_FALSE(equal({.max = 0.09}));
  EXPECT_TRUE(equal({.rms = 0.01}));
  EXPECT_FALSE(equal({.rms = 0.009}));
  EXPECT_TRUE(equal({.psnr_db = 40}));
  EXPECT_FALSE(equal({.psnr_db = 41}));
  EXPECT_TRUE(equal({.differing = 0.5}));
  EXPECT_FALSE(equal({.differing = 0.4}));
  EXPECT_TRUE(equal({.flip = 0.05}));
  EXPECT_FALSE(equal({.flip = 0.04}));
  c.comparable = false;
  EXPECT_FALSE(equal({.max = 1}));
}

TEST(Compare, PngAndExrOfOnePictureAgreeToARoundedCode) {
  const Scratch scratch;
  auto planes = test::made_up_planes(40, 30, 3);
  for (Field<float>& plane : planes)
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x) plane(x, y) = std::clamp(plane(x, y), 0.0f, 1.0f);
  write_png(scratch.path("a.png"), planes);
  write_exr(scratch.path("a.exr"), planes);
  const auto result = compare(scratch.path("a.png"), scratch.path("a.exr"));
  ASSERT_TRUE(result);
  // Half a code of 255 times the steepest slope of the decoding curve, 1.055 * 2.4 / 1.055.
  for (const PlaneDifference& d : result->planes) EXPECT_LT(d.max, 0.5 / 255 * 2.4);
  EXPECT_GT(result->planes[0].max, 0);
}

TEST(Compare, DifferentSizesDifferWithAReason) {
  const Scratch scratch;
  write_png(scratch.path("a.png"), test::made_up_planes(40, 30, 3));
  write_png(scratch.path("b.png"), test::made_up_planes(30, 40, 3));
  CompareThresholds loose;
  loose.max = 1;
  const auto result = compare(scratch.path("a.png"), scratch.path("b.png"), loose);
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->equal);
  EXPECT_EQ(result->notes[0], "40 x 30 pixels against 30 x 40");
}

TEST(Compare, FindsTheOnePlaneOfAStateThatDiffers) {
  const Scratch scratch;
  StateDump dump = test::made_up_dump(20, 10, 2, 3);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  EXPECT_TRUE(compare(scratch.path("a.h5"), scratch.path("a.h5"))->equal);
  dump.state.channel(1, 2)(5, 6) += 0.25f;
  dump.model.nu_max_m2_s = 0.5f;
  dump.lighting.exposure_ev = 1;
  ASSERT_TRUE(write_state(scratch.path("b.h5"), dump, {}));
  const auto result = compare(scratch.path("a.h5"), scratch.path("b.h5"));
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_FALSE(result->equal);
  for (const PlaneDifference& d : result->planes) {
    EXPECT_EQ(d.differing > 0, d.name == "/layers/pigment[1,2]") << d.name;
    if (d.differing > 0) {
      EXPECT_EQ(std::pair(d.max_x, d.max_y), std::pair(5, 6));
    }
  }
  EXPECT_EQ(result->notes,
            (std::vector<std::string>{"nu_max: 0.02 against 0.5", "the lighting differs"}));
}

TEST(Compare, AStateAgainstAPictureIsBadInput) {
  const Scratch scratch;
  ASSERT_TRUE(write_state(scratch.path("a.h5"), test::made_up_dump(20, 10, 2, 3), {}));
  write_png(scratch.path("a.png"), test::made_up_planes(20, 10, 3));
  const auto result = compare(scratch.path("a.h5"), scratch.path("a.png"));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kBadInput);
}

TEST(Compare, JsonHasEverythingAndNoInfinity) {
  const Scratch scratch;
  write_png(scratch.path("a.png"), test::made_up_planes(20, 10, 3));
  const auto result = compare(scratch.path("a.png"), scratch.path("a.png"));
  const auto json = nlohmann::json::parse(comparison_json(*result));
  EXPECT_TRUE(json["equal"]);
  EXPECT_EQ(json["planes"].size(), 3u);
  EXPECT_EQ(json["planes"][0]["name"], "R");
  EXPECT_TRUE(json["planes"][0]["psnr_db"].is_null());
  EXPECT_EQ(json["flip"]["mean"], 0.0);
}

}  // namespace
}  // namespace pentimento

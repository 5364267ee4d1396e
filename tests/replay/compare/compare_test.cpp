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

void write_png(const std::string& path, const std::vector<Field<float>>& planes,
               const ColorEncoding& color = {}, int bit_depth = 8) {
  PngOptions options;
  options.color = color;
  options.bit_depth = bit_depth;
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
  return compare_files(a, b, thresholds, 1);
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

TEST(Compare, PicturesOfDifferentProfilesAreComparedAsSrgb) {
  const Scratch scratch;
  std::vector<Field<float>> planes;
  for (int c = 0; c < 3; ++c) planes.emplace_back(40, 30);
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 40; ++x) {
      planes[0](x, y) = static_cast<float>(x) / 40;
      planes[1](x, y) = static_cast<float>(y) / 30;
      planes[2](x, y) = static_cast<float>((3 * x + 5 * y) % 31) / 31;
    }
  write_png(scratch.path("a.png"), planes, {}, 16);
  for (const ColorProfile profile : {ColorProfile::kDisplayP3, ColorProfile::kAdobeRgb}) {
    write_png(scratch.path("b.png"), planes, {profile}, 16);
    CompareThresholds thresholds;
    thresholds.rms = 1e-4;
    thresholds.flip = 1e-3;
    const auto result = compare(scratch.path("a.png"), scratch.path("b.png"), thresholds);
    ASSERT_TRUE(result);
    // Rounding to 16 bits on both sides: some codes near black, where the curves are steepest.
    // Taken as sRGB, the profile's numbers are off by hundredths.
    EXPECT_TRUE(result->equal) << comparison_text(*result);
    ASSERT_EQ(result->notes.size(), 1u);
    EXPECT_NE(result->notes[0].find(profile_title(profile)), std::string::npos);
    const auto same = compare(scratch.path("b.png"), scratch.path("b.png"));
    ASSERT_TRUE(same);
    EXPECT_TRUE(same->equal && same->notes.empty() && same->flip_mean == 0);
  }
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
  // The worst pixel is the one that differs; most others do not.
  EXPECT_GT(*strict->flip_max, 10 * *strict->flip_mean);
  CompareThresholds loose;
  loose.max = 1.01 / 255;
  loose.flip = 0.01;
  EXPECT_TRUE(compare(scratch.path("a.png"), scratch.path("b.png"), loose)->equal);
  loose.differing = 0.0001;
  EXPECT_FALSE(compare(scratch.path("a.png"), scratch.path("b.png"), loose)->equal);
}

/// Two layers of one channel: 3 x 2 cells, or each of them k x k cells of the same mean.
CanvasState blocks(int k) {
  CanvasState s = make_canvas_state({3 * k, 2 * k, 0.3, 0.2}, 2, 1, 3, 0.9f);
  for (int y = 0; y < 2 * k; ++y)
    for (int x = 0; x < 3 * k; ++x) {
      const float cell = static_cast<float>(x / k + 3 * (y / k));
      const float ripple = k == 1 ? 0.0f : (x % 2 == 0 ? 0.25f : -0.25f);
      s.depth_m(x, y) = cell + (cell > 0 ? ripple : 0.0f);
      s.channel(0, 0)(x, y) = 2 * cell;
      s.channel(1, 0)(x, y) = 8;
    }
  return s;
}

TEST(CompareReduced, FindsTheSamePaintingOnAFinerCanvas) {
  const CanvasState coarse = blocks(1), fine = blocks(4);
  EXPECT_EQ(whole_ratio(coarse.geometry, fine.geometry), 4);
  EXPECT_EQ(whole_ratio(fine.geometry, coarse.geometry), 0);
  EXPECT_EQ(whole_ratio({10, 10}, {20, 30}), 0);
  ChannelBasis basis;
  basis.name = {"red"};
  basis.amount = Eigen::VectorXf::Constant(1, 0.5f);
  Comparison same;
  const Threads threads(2);
  compare_reduced(StateSource(coarse), StateSource(fine), basis, threads, same);
  std::vector<std::string> names;
  for (const PlaneDifference& d : same.planes) {
    names.push_back(d.name);
    EXPECT_EQ(d.max, 0) << d.name;  // quarters and small wholes: exact
    EXPECT_EQ(d.relative_l2, 0) << d.name;
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"/fluid/depth", "dried paint", "/layers/pigment[0,0]",
                                      "/layers/pigment[1,0]", "pigment red", "pigment, total"}));
}

TEST(CompareReduced, MeasuresWhatDiffers) {
  const CanvasState coarse = blocks(1);
  CanvasState fine = blocks(2);
  fine.channel(0, 0)(5, 3) += 4;  // block (2, 1), which holds 10, is 1 too much
  ChannelBasis basis;
  basis.name = {"red"};
  basis.amount = Eigen::VectorXf::Constant(1, 0.5f);
  Comparison c;
  compare_reduced(StateSource(coarse), StateSource(fine), basis, Threads(1), c);
  const PlaneDifference& layer = c.planes[2];
  EXPECT_EQ(layer.max, 1);
  EXPECT_EQ(layer.max_x * 10 + layer.max_y, 21);
  EXPECT_DOUBLE_EQ(*layer.worst_block, 0.1);
  // 0 2 4 6 8 10: squares sum to 220.
  EXPECT_DOUBLE_EQ(*layer.relative_l2, 1 / std::sqrt(220.0));
  EXPECT_DOUBLE_EQ(*c.planes[4].worst_block, 1.0 / 18);  // both layers
  CompareThresholds allowed;
  allowed.relative_l2 = 0.1;
  decide(c, allowed);
  EXPECT_TRUE(c.equal);
  allowed.worst_block = 0.09;
  decide(c, allowed);
  EXPECT_TRUE(c.equal);  // one layer's tenth is not judged, only their sum's
  allowed.worst_block = 0.05;
  decide(c, allowed);
  EXPECT_FALSE(c.equal);
}

TEST(ComparePictures, TheLargerIsReducedInLinearLight) {
  const Scratch scratch;
  std::vector<Field<float>> small, large;
  for (int c = 0; c < 3; ++c) {
    small.emplace_back(8, 6, 0.5f);
    large.emplace_back(16, 12);
    for (int y = 0; y < 12; ++y)
      for (int x = 0; x < 16; ++x) large.back()(x, y) = (x + y) % 2 == 0 ? 1.0f : 0.0f;
  }
  write_png(scratch.path("a.png"), small);
  write_png(scratch.path("b.png"), large);
  CompareThresholds allowed;
  allowed.max = 0.51 / 255;  // black and white are exact, their mean is half a code from a code
  for (const bool turned : {false, true}) {
    const auto c = turned ? compare(scratch.path("b.png"), scratch.path("a.png"), allowed)
                          : compare(scratch.path("a.png"), scratch.path("b.png"), allowed);
    ASSERT_TRUE(c) << c.error().message;
    EXPECT_EQ(c->reduced, 2);
    EXPECT_TRUE(c->equal) << c->planes[0].max;
    EXPECT_TRUE(c->flip_mean);
  }
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

TEST(Compare, TellsDumpsThatReflectDifferently) {
  const Scratch scratch;
  StateDump dump = test::made_up_dump(20, 10, 2, 3);
  ASSERT_TRUE(write_state(scratch.path("a.h5"), dump, {}));
  dump.lighting.reflection.mirror = !dump.lighting.reflection.mirror;
  ASSERT_TRUE(write_state(scratch.path("b.h5"), dump, {}));
  EXPECT_EQ(compare(scratch.path("a.h5"), scratch.path("b.h5"))->notes,
            (std::vector<std::string>{"the lighting differs"}));
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

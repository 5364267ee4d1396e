#include "formats/png/png_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/image/read_image.h"
#include "formats/io/provenance.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;
using test::slurp;

const std::vector<std::string> kRgb = {"R", "G", "B"};

Result<Published> write_png(const std::string& path, const std::vector<Field<float>>& planes,
                            PngOptions options, int strip_rows) {
  options.width = planes[0].width();
  options.height = planes[0].height();
  auto file = create_png(path, options);
  if (!file) return file.error();
  if (auto written = test::write_strips(**file, planes, kRgb, strip_rows); !written)
    return written.error();
  return (*file)->finish();
}

/// The standard's formula in double precision.
double srgb(double v) {
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

/// Darker by three quarters of what is too bright, then towards the neutral of equal luminance
/// (Rec. 709), until it fits.
std::array<double, 3> fitted(std::array<double, 3> v) {
  const double brightest = std::max({v[0], v[1], v[2], 1.0});
  for (double& c : v) c *= std::pow(brightest, -0.75);
  const double y = std::clamp(0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2], 0.0, 1.0);
  double t = 1;
  for (const double c : v) {
    if (c > 1) t = std::min(t, (1 - y) / (c - y));
    if (c < 0) t = std::min(t, y / (y - c));
  }
  for (double& c : v) c = y + t * (c - y);
  return v;
}

void expect_nearest_codes(const std::vector<Field<float>>& planes, const Image& image, int max) {
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      std::array<double, 3> light{};
      for (std::size_t c = 0; c < 3; ++c) light[c] = static_cast<double>(planes[c](x, y));
      const bool inside = std::min({light[0], light[1], light[2]}) >= 0 &&
                          std::max({light[0], light[1], light[2]}) <= 1;
      const std::array<double, 3> shown = fitted(light);
      for (std::size_t c = 0; c < 3; ++c) {
        const double code = static_cast<double>(image.plane[c](x, y)) * max;
        // Half a code by rounding, and what single precision adds to a code of up to 65535; four
        // digits of the luminance's weights add up to 1e-4 of light, 12.92 times that near black.
        const double tolerance = 0.501 + max * (inside ? 1.2e-7 : 1.3e-3);
        ASSERT_NEAR(code, srgb(shown[c]) * max, tolerance) << x << "," << y << " plane " << c;
      }
    }
}

class PngDepth : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Depths, PngDepth, testing::Values(8, 16));

TEST_P(PngDepth, LibpngReadsTheNearestSrgbCodes) {
  const Scratch scratch;
  const std::string path = scratch.path("a.png");
  const auto planes = test::made_up_planes(61, 47, 3);
  PngOptions options;
  options.bit_depth = GetParam();
  ASSERT_TRUE(write_png(path, planes, options, 10));
  // The reader takes libpng's warnings as errors.
  const auto image = read_image(path, {SampleMeaning::kRaw, {}});
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->bits, GetParam());
  EXPECT_EQ(image->name, kRgb);
  expect_nearest_codes(planes, *image, GetParam() == 8 ? 255 : 65535);
}

TEST_P(PngDepth, PngcheckIsSilentAndFindsOneColourChunk) {
  const Scratch scratch;
  const std::string path = scratch.path("a.png");
  PngOptions options;
  options.bit_depth = GetParam();
  options.dpi = 300;
  options.provenance = {{"software", "pentimento"}, {"title", "\xC3\xB6l"}};
  // Large enough for several blocks of rows.
  ASSERT_TRUE(write_png(path, test::made_up_planes(500, 750, 3), options, 128));
  const auto [status, text] = test::run("pngcheck -v " + path);
  EXPECT_EQ(status, 0) << text;
  EXPECT_NE(text.find("chunk sRGB"), std::string::npos) << text;
  EXPECT_EQ(text.find("gAMA"), std::string::npos);
  EXPECT_EQ(text.find("iCCP"), std::string::npos);
  EXPECT_NE(text.find("11811x11811 pixels/meter (300 dpi)"), std::string::npos) << text;
  const auto [quiet_status, quiet] = test::run("pngcheck -q " + path);
  EXPECT_EQ(quiet_status, 0);
  EXPECT_EQ(quiet, "");
}

TEST_P(PngDepth, BytesDependNeitherOnThreadsNorOnStrips) {
  const Scratch scratch;
  const auto planes = test::made_up_planes(700, 900, 3);
  PngOptions options;
  options.bit_depth = GetParam();
  ASSERT_TRUE(write_png(scratch.path("a.png"), planes, options, 900));
  const std::string expected = slurp(scratch.path("a.png"));
  for (const auto& [threads, rows] : {std::pair{1, 17}, {2, 900}, {7, 333}}) {
    options.threads = threads;
    ASSERT_TRUE(write_png(scratch.path("b.png"), planes, options, rows));
    EXPECT_EQ(slurp(scratch.path("b.png")), expected) << threads << " threads, " << rows;
  }
}

TEST(PngWriter, SmallestPicturesAreRight) {
  const Scratch scratch;
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 3}}) {
    const auto planes = test::made_up_planes(width, height, 3);
    ASSERT_TRUE(write_png(scratch.path("a.png"), planes, {}, 2));
    const auto image = read_image(scratch.path("a.png"), {SampleMeaning::kRaw, {}});
    ASSERT_TRUE(image) << image.error().message;
    expect_nearest_codes(planes, *image, 255);
  }
}

TEST(PngWriter, KeepsProvenance) {
  const Scratch scratch;
  const std::string path = scratch.path("a.png");
  PngOptions options;
  options.dpi = 254;
  options.provenance = {{"software", "pentimento 0.1"},
                        {"title", "\xC3\xB6l \xE2\x82\xAC"},
                        {"command", "render a.jsonl\n-o b.png"}};
  ASSERT_TRUE(write_png(path, test::made_up_planes(5, 4, 3), options, 4));
  const auto described = describe_file(path);
  ASSERT_TRUE(described) << described.error().message;
  EXPECT_EQ(described->provenance, options.provenance);
  EXPECT_EQ(described->width, 5);
  EXPECT_EQ(described->height, 4);
  EXPECT_EQ(described->bits, 8);
  EXPECT_DOUBLE_EQ(described->dpi, 254);  // 10000 pixels per metre: nothing is rounded
}

TEST(PngWriter, ReplacesBytesThatAreNotUtf8) {
  const Scratch scratch;
  PngOptions options;
  options.provenance = {{"file", "a\xFF.jsonl"}};
  ASSERT_TRUE(write_png(scratch.path("a.png"), test::made_up_planes(5, 4, 3), options, 4));
  EXPECT_EQ(describe_file(scratch.path("a.png"))->provenance[0].second, "a\xEF\xBF\xBD.jsonl");
}

TEST(PngWriter, RefusesAKeyThatPngCannotHold) {
  const Scratch scratch;
  PngOptions options;
  options.provenance = {{std::string(80, 'k'), "v"}};
  const auto result = write_png(scratch.path("a.png"), test::made_up_planes(5, 4, 3), options, 4);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kUsage);
  EXPECT_EQ(scratch.files(), 0u);
}

TEST(PngWriter, ANanIsAnErrorAndLeavesNoFile) {
  const Scratch scratch;
  auto planes = test::made_up_planes(5, 4, 3);
  planes[1](2, 3) = std::numeric_limits<float>::quiet_NaN();
  const auto result = write_png(scratch.path("a.png"), planes, {}, 2);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kNonFinite);
  EXPECT_NE(result.error().message.find("row 3"), std::string::npos) << result.error().message;
  EXPECT_EQ(scratch.files(), 0u);
}

TEST(PngWriter, InfinityAndWhiteAreTheLargestCode) {
  const Scratch scratch;
  auto planes = test::made_up_planes(2, 1, 3);
  for (auto& plane : planes) {
    plane(0, 0) = std::numeric_limits<float>::infinity();
    plane(1, 0) = 1.0f;
  }
  ASSERT_TRUE(write_png(scratch.path("a.png"), planes, {}, 1));
  const auto image = read_image(scratch.path("a.png"));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->plane[0](0, 0), 1.0f);
  EXPECT_EQ(image->plane[0](1, 0), 1.0f);
}

TEST(PngWriter, RefusesSidesThatReadersRefuse) {
  PngOptions options;
  options.width = 1'000'001;
  options.height = 1;
  const auto file = create_png("a.png", options);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kLimit);
}

TEST(PngNumbers, AreCodesOfAnEvenScaleWithoutAColour) {
  const Scratch scratch;
  std::vector<Field<float>> planes;
  planes.emplace_back(4, 2);
  planes[0](0, 0) = -0.5f;  // code 0
  planes[0](1, 0) = 0.0f;   // in the middle
  planes[0](2, 0) = 0.5f;   // the end
  planes[0](3, 0) = 7.0f;   // beyond it
  planes[0](0, 1) = -9.0f;
  for (const int channels : {1, 3}) {
    for (int c = static_cast<int>(planes.size()); c < channels; ++c)
      planes.push_back(planes[0].clone());
    PngOptions options;
    options.bit_depth = 16;
    options.numbers = {-0.5, 1.0 / 65535, channels};
    const std::string path = scratch.path("a.png");
    ASSERT_TRUE(write_png(path, planes, options, 1));
    const auto image = read_image(path, {SampleMeaning::kRaw, {}});
    ASSERT_TRUE(image) << image.error().message;
    EXPECT_EQ(image->plane.size(), static_cast<std::size_t>(channels));
    EXPECT_TRUE(image->profile_title.empty());
    const auto code = [&](int x, int y) { return std::lround(image->plane[0](x, y) * 65535); };
    EXPECT_EQ(code(0, 0), 0);
    EXPECT_EQ(code(1, 0), 32768);  // 32767.5 is rounded up
    EXPECT_EQ(code(2, 0), 65535);
    EXPECT_EQ(code(3, 0), 65535);
    EXPECT_EQ(code(0, 1), 0);
    EXPECT_EQ(test::run("pngcheck -q " + path).first, 0);
  }
  planes[0](2, 1) = std::numeric_limits<float>::quiet_NaN();
  PngOptions options;
  options.bit_depth = 16;
  options.numbers.emplace();
  EXPECT_EQ(write_png(scratch.path("b.png"), planes, options, 1).error().code,
            ErrorCode::kNonFinite);
  EXPECT_FALSE(std::filesystem::exists(scratch.path("b.png")));
}

}  // namespace
}  // namespace pentimento

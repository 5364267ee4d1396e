// What another programme's colour management sees in our pictures: LittleCMS reads the profile out
// of the file and turns the pixels into Lab; that must be the Lab of the light that went in.

#include <gtest/gtest.h>
#include <lcms2.h>
#include <png.h>

#include <algorithm>
#include <cmath>

#include "formats/exr/exr_writer.h"
#include "formats/image/read_image.h"
#include "formats/io/provenance.h"
#include "formats/png/png_writer.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;
constexpr int kSteps = 11;  // per channel
constexpr int kWidth = kSteps * kSteps, kHeight = kSteps;

/// All colours of a grid in linear light, denser towards black.
std::vector<Field<float>> colours() {
  std::vector<Field<float>> planes;
  for (int c = 0; c < 3; ++c) planes.emplace_back(kWidth, kHeight);
  const auto level = [](int i) {
    const float v = static_cast<float>(i) / (kSteps - 1);
    return v * v;
  };
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      planes[0](x, y) = level(x % kSteps);
      planes[1](x, y) = level(x / kSteps);
      planes[2](x, y) = level(y);
    }
  return planes;
}

void write(const std::string& path, const std::vector<Field<float>>& planes,
           const ColorEncoding& color, int bit_depth) {
  PngOptions options;
  options.width = planes[0].width();
  options.height = planes[0].height();
  options.bit_depth = bit_depth;
  options.color = color;
  auto file = create_png(path, options);
  ASSERT_TRUE(file);
  ASSERT_TRUE(test::write_strips(**file, planes, {"R", "G", "B"}, 5));
  ASSERT_TRUE((*file)->finish());
}

/// Pixels as 16-bit RGB and the ICC profile, by libpng's simplest use (empty without iCCP).
struct ReadPng {
  std::vector<cmsUInt16Number> pixels;
  std::vector<std::uint8_t> profile;
};

void read_with_libpng(const std::string& path, ReadPng& out) {
  std::FILE* file = std::fopen(path.c_str(), "rb");
  ASSERT_NE(file, nullptr);
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, file);
  png_read_png(png, info, PNG_TRANSFORM_EXPAND_16 | PNG_TRANSFORM_SWAP_ENDIAN, nullptr);
  png_bytepp rows = png_get_rows(png, info);
  const std::size_t row_values = 3 * png_get_image_width(png, info);
  for (std::size_t y = 0; y < png_get_image_height(png, info); ++y) {
    const auto* values = reinterpret_cast<const cmsUInt16Number*>(rows[y]);
    out.pixels.insert(out.pixels.end(), values, values + row_values);
  }
  png_charp name = nullptr;
  int method = 0;
  png_bytep bytes = nullptr;
  png_uint_32 size = 0;
  if (png_get_iCCP(png, info, &name, &method, &bytes, &size) != 0)
    out.profile.assign(bytes, bytes + size);
  png_destroy_read_struct(&png, &info, nullptr);
  std::fclose(file);
}

/// To Lab (D50) of `count` pixels.
std::vector<cmsCIELab> to_lab(cmsHPROFILE from, cmsUInt32Number format, const void* pixels,
                              std::size_t count) {
  cmsHPROFILE lab = cmsCreateLab4Profile(nullptr);
  cmsHTRANSFORM transform = cmsCreateTransform(from, format, lab, TYPE_Lab_DBL,
                                               INTENT_RELATIVE_COLORIMETRIC, cmsFLAGS_NOOPTIMIZE);
  std::vector<cmsCIELab> out(count);
  cmsDoTransform(transform, pixels, out.data(), static_cast<cmsUInt32Number>(count));
  cmsDeleteTransform(transform);
  cmsCloseProfile(lab);
  return out;
}

/// Lab of scene-linear light: a profile of Rec. 709's primaries with straight curves, made here
/// from the standard's numbers.
std::vector<cmsCIELab> lab_of_light(const std::vector<Field<float>>& planes) {
  std::vector<double> light;
  for (int y = 0; y < planes[0].height(); ++y)
    for (int x = 0; x < planes[0].width(); ++x)
      for (const Field<float>& plane : planes) light.push_back(static_cast<double>(plane(x, y)));
  const cmsCIExyY white = {0.3127, 0.3290, 1};
  const cmsCIExyYTRIPLE primaries = {{0.64, 0.33, 1}, {0.30, 0.60, 1}, {0.15, 0.06, 1}};
  cmsToneCurve* straight = cmsBuildGamma(nullptr, 1);
  cmsToneCurve* curves[] = {straight, straight, straight};
  cmsHPROFILE profile = cmsCreateRGBProfile(&white, &primaries, curves);
  auto lab = to_lab(profile, TYPE_RGB_DBL, light.data(), light.size() / 3);
  cmsCloseProfile(profile);
  cmsFreeToneCurve(straight);
  return lab;
}

/// CIEDE2000 between what LittleCMS sees in the file and the light, largest and mean.
struct Difference {
  double max = 0, mean = 0;
};
Difference difference(const std::string& path, const std::vector<Field<float>>& planes) {
  ReadPng read;
  read_with_libpng(path, read);
  cmsHPROFILE profile =
      read.profile.empty()
          ? cmsCreate_sRGBProfile()
          : cmsOpenProfileFromMem(read.profile.data(),
                                  static_cast<cmsUInt32Number>(read.profile.size()));
  const auto seen = to_lab(profile, TYPE_RGB_16, read.pixels.data(), read.pixels.size() / 3);
  cmsCloseProfile(profile);
  const auto meant = lab_of_light(planes);
  Difference d;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double e = cmsCIE2000DeltaE(&seen[i], &meant[i], 1, 1, 1);
    d.max = std::max(d.max, e);
    d.mean += e / static_cast<double>(seen.size());
  }
  return d;
}

class RoundTrip : public testing::TestWithParam<ColorProfile> {};
INSTANTIATE_TEST_SUITE_P(Profiles, RoundTrip, testing::ValuesIn(kColorProfiles));

TEST_P(RoundTrip, EightBitsAreWithinOneDeltaE2000) {
  const Scratch scratch;
  const auto planes = colours();
  write(scratch.path("a.png"), planes, {GetParam()}, 8);
  const Difference d = difference(scratch.path("a.png"), planes);
  // The promise; rounding to 8 bits alone makes most of it.
  EXPECT_LE(d.max, 1.0);
  EXPECT_LE(d.mean, 0.3);
  RecordProperty("max", std::to_string(d.max));
  std::printf("%s, 8 bit: CIEDE2000 max %.3f, mean %.3f\n", profile_title(GetParam()).data(), d.max,
              d.mean);
}

TEST_P(RoundTrip, SixteenBitsAreAlmostExact) {
  const Scratch scratch;
  const auto planes = colours();
  write(scratch.path("a.png"), planes, {GetParam()}, 16);
  const Difference d = difference(scratch.path("a.png"), planes);
  // What remains is the profile's own numbers, 16 binary places each.
  EXPECT_LE(d.max, 0.05);
  std::printf("%s, 16 bit: CIEDE2000 max %.4f, mean %.4f\n", profile_title(GetParam()).data(),
              d.max, d.mean);
}

TEST_P(RoundTrip, ADitheredAreaHasTheRightMean) {
  const Scratch scratch;
  std::vector<Field<float>> planes, one;
  for (const float v : {0.05f, 0.3f, 0.12f}) {
    planes.emplace_back(128, 128, v);
    one.emplace_back(1, 1, v);
  }
  ColorEncoding color = {GetParam()};
  color.dither = true;
  write(scratch.path("a.png"), planes, color, 8);
  write(scratch.path("b.png"), one, {GetParam()}, 16);
  ReadPng dithered, exact;
  read_with_libpng(scratch.path("a.png"), dithered);
  read_with_libpng(scratch.path("b.png"), exact);
  for (std::size_t c = 0; c < 3; ++c) {
    double mean = 0;
    for (std::size_t i = c; i < dithered.pixels.size(); i += 3) mean += dithered.pixels[i];
    mean /= 128.0 * 128;
    // Half a code of deviation over 128 rows and columns: five times 257 / 2 / 128.
    EXPECT_NEAR(mean, exact.pixels[c], 5.1);
  }
}

TEST_P(RoundTrip, OurReaderGivesTheLightBack) {
  const Scratch scratch;
  const auto planes = colours();
  write(scratch.path("a.png"), planes, {GetParam()}, 16);
  const auto rgb = read_rgb(scratch.path("a.png"));
  ASSERT_TRUE(rgb);
  for (std::size_t c = 0; c < 3; ++c)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        // Half a code of 16 bits, at the curve's steepest 2.4 times, through a matrix of norm 2.
        ASSERT_NEAR((*rgb)[c](x, y), planes[c](x, y), 5e-5f);
      }
  EXPECT_EQ(describe_file(scratch.path("a.png"))->profile, profile_title(GetParam()));
}

TEST_P(RoundTrip, AnExrKeepsEvenWhatTheProfileCannotShow) {
  const Scratch scratch;
  auto planes = colours();
  planes[0](3, 3) = -0.2f;
  planes[1](3, 3) = 4;
  ExrOptions options;
  options.width = kWidth;
  options.height = kHeight;
  options.full_float = true;
  options.channels = {"R", "G", "B"};
  options.profile = GetParam();
  auto file = create_exr(scratch.path("a.exr"), options);
  ASSERT_TRUE(file);
  ASSERT_TRUE(test::write_strips(**file, planes, options.channels, 5));
  ASSERT_TRUE((*file)->finish());
  const auto rgb = read_rgb(scratch.path("a.exr"));
  ASSERT_TRUE(rgb);
  for (std::size_t c = 0; c < 3; ++c)
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        // Single precision, on values of up to 4.
        ASSERT_NEAR((*rgb)[c](x, y), planes[c](x, y), 1e-6f);
      }
  EXPECT_EQ(describe_file(scratch.path("a.exr"))->profile,
            std::string(profile_title(GetParam())) + " primaries");
}

TEST(RoundTripBytes, DependNeitherOnThreadsNorOnStrips) {
  const Scratch scratch;
  const auto planes = test::made_up_planes(300, 200, 3);
  std::string expected;
  for (const auto& [threads, rows] : {std::pair{1, 200}, {2, 17}, {7, 64}}) {
    PngOptions options;
    options.width = 300;
    options.height = 200;
    options.threads = threads;
    options.color = {ColorProfile::kDisplayP3, true};
    auto file = create_png(scratch.path("a.png"), options);
    ASSERT_TRUE(file);
    ASSERT_TRUE(test::write_strips(**file, planes, {"R", "G", "B"}, rows));
    ASSERT_TRUE((*file)->finish());
    if (expected.empty()) expected = test::slurp(scratch.path("a.png"));
    EXPECT_EQ(test::slurp(scratch.path("a.png")), expected) << threads << " threads, " << rows;
  }
}

TEST(RoundTripBytes, ACropIsDitheredAsThePartOfTheWhole) {
  const Scratch scratch;
  std::vector<Field<float>> whole, part;
  for (int c = 0; c < 3; ++c) {
    whole.emplace_back(60, 40, 0.2f);
    part.emplace_back(20, 10, 0.2f);
  }
  write(scratch.path("a.png"), whole, {ColorProfile::kSrgb, true}, 8);
  write(scratch.path("b.png"), part, {ColorProfile::kSrgb, true, 30, 15}, 8);
  const auto a = read_image(scratch.path("a.png")), b = read_image(scratch.path("b.png"));
  ASSERT_TRUE(a && b);
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x) ASSERT_EQ(b->plane[0](x, y), a->plane[0](x + 30, y + 15));
}

}  // namespace
}  // namespace pentimento

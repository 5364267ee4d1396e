#include "formats/image/read_image.h"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <png.h>

#include <cmath>

#include "core/optics/srgb.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;

/// `bytes` as an 8-bit PNG through libpng's simple interface; format as PNG_FORMAT_...
void write_8_bit(const std::string& path, int width, int height, png_uint_32 format,
                 const std::vector<std::uint8_t>& bytes) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  ASSERT_TRUE(png_image_write_to_file(&image, path.c_str(), 0, bytes.data(), 0, nullptr));
}

void write_probe(const std::string& path, const std::vector<Field<float>>& planes,
                 Imf::Compression compression, int x0, int y0) {
  const Imath::Box2i window({x0, y0}, {x0 + planes[0].width() - 1, y0 + planes[0].height() - 1});
  Imf::Header header(window, window);
  header.compression() = compression;
  Imf::FrameBuffer buffer;
  const char* names[] = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    const std::ptrdiff_t stride = planes[c].view().stride();
    auto* origin = const_cast<char*>(reinterpret_cast<const char*>(planes[c].row(0) - x0)) -
                   y0 * stride * std::ptrdiff_t{sizeof(float)};
    buffer.insert(names[c], Imf::Slice(Imf::FLOAT, origin, sizeof(float),
                                       static_cast<std::size_t>(stride) * sizeof(float)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(planes[0].height());
}

TEST(ReadImage, DecodesSrgbOrKeepsStoredValues) {
  const Scratch scratch;
  write_8_bit(scratch.path("a.png"), 2, 1, PNG_FORMAT_RGB, {0, 128, 255, 10, 20, 30});
  const auto light = read_image(scratch.path("a.png"));
  const auto raw = read_image(scratch.path("a.png"), {SampleMeaning::kRaw, {}});
  ASSERT_TRUE(light && raw);
  EXPECT_EQ(light->plane[1](0, 0), static_cast<float>(srgb_to_linear(128.0 / 255)));
  EXPECT_EQ(raw->plane[1](0, 0), static_cast<float>(128.0 / 255));
  EXPECT_EQ(light->plane[2](0, 0), 1.0f);
  EXPECT_EQ(raw->plane[0](1, 0), static_cast<float>(10.0 / 255));
  EXPECT_FALSE(light->stored_float);
  EXPECT_EQ(light->format, "png");
}

TEST(ReadImage, GreyIsOnePlaneAndThreeEqualColours) {
  const Scratch scratch;
  write_8_bit(scratch.path("a.png"), 2, 1, PNG_FORMAT_GRAY, {0, 200});
  const auto image = read_image(scratch.path("a.png"));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->name, std::vector<std::string>{"Y"});
  const auto rgb = read_rgb(scratch.path("a.png"));
  ASSERT_TRUE(rgb);
  EXPECT_EQ((*rgb)[0](1, 0), (*rgb)[2](1, 0));
}

TEST(ReadImage, ATipIsItsAlphaOrItsGrey) {
  const Scratch scratch;
  write_8_bit(scratch.path("a.png"), 2, 1, PNG_FORMAT_RGBA, {9, 9, 9, 51, 9, 9, 9, 255});
  write_8_bit(scratch.path("g.png"), 2, 1, PNG_FORMAT_GRAY, {51, 255});
  const auto alpha = read_tip(scratch.path("a.png"));
  const auto grey = read_tip(scratch.path("g.png"));
  ASSERT_TRUE(alpha && grey);
  EXPECT_FLOAT_EQ((*alpha)(0, 0), 0.2f);
  EXPECT_FLOAT_EQ((*alpha)(1, 0), 1.0f);
  EXPECT_FLOAT_EQ((*grey)(0, 0), 0.2f);
  EXPECT_FLOAT_EQ((*grey)(1, 0), 1.0f);
}

TEST(ReadImage, ATextureIsStoredValues) {
  const Scratch scratch;
  write_8_bit(scratch.path("a.png"), 1, 1, PNG_FORMAT_RGB, {51, 102, 204});
  const auto grey = read_grey(scratch.path("a.png"));
  ASSERT_TRUE(grey);
  EXPECT_FLOAT_EQ((*grey)(0, 0), (0.2f + 0.4f + 0.8f) / 3);
}

TEST(ReadImage, DwaProbesComeBackNearlyAsTheyWere) {
  const Scratch scratch;
  std::vector<Field<float>> planes;
  for (int c = 0; c < 3; ++c) {
    Field<float>& plane = planes.emplace_back(64, 32);
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x) plane(x, y) = 1.0f + 0.01f * static_cast<float>(x + c * y);
  }
  for (const Imf::Compression compression : {Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
    write_probe(scratch.path("a.exr"), planes, compression, 0, 0);
    const auto rgb = read_rgb(scratch.path("a.exr"));
    ASSERT_TRUE(rgb) << rgb.error().message;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 64; ++x)
        // DWA is lossy; at its default level a smooth ramp is good to a few percent.
        ASSERT_NEAR((*rgb)[1](x, y), planes[1](x, y), 0.05f);
  }
}

TEST(ReadImage, AnExrMayStartAnywhere) {
  const Scratch scratch;
  const auto planes = test::made_up_planes(20, 10, 3);
  write_probe(scratch.path("a.exr"), planes, Imf::ZIP_COMPRESSION, -7, 1000);
  const auto rgb = read_rgb(scratch.path("a.exr"));
  ASSERT_TRUE(rgb) << rgb.error().message;
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x) ASSERT_EQ((*rgb)[2](x, y), planes[2](x, y));
}

/// Radiance's flat form: four bytes a pixel, value = (mantissa + 0) / 256 * 2^(exponent - 128).
std::string radiance_file(int width, int height, const std::string& pixel) {
  std::string text = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) + " +X " +
                     std::to_string(width) + "\n";
  for (int i = 0; i < width * height; ++i) text += pixel;
  return text;
}

TEST(ReadImage, ReadsRadiancePictures) {
  const Scratch scratch;
  // Mantissas 128, 64, 32 with exponent 130: 2, 1, 1/2.
  test::spill(scratch.path("a.hdr"), radiance_file(4, 3, "\x80\x40\x20\x82"));
  const auto image = read_image(scratch.path("a.hdr"));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->format, "hdr");
  EXPECT_TRUE(image->stored_float);
  EXPECT_EQ(image->name, (std::vector<std::string>{"R", "G", "B"}));
  // Some decoders add half a mantissa step.
  EXPECT_NEAR(image->plane[0](1, 1), 2.0f, 0.01f);
  EXPECT_NEAR(image->plane[1](1, 1), 1.0f, 0.01f);
  EXPECT_NEAR(image->plane[2](1, 1), 0.5f, 0.01f);
}

/// Baseline TIFF, 8 bit RGB, one strip.
std::string tiff_file(std::uint8_t r, std::uint8_t g, std::uint8_t b) {
  std::string out("II*\0\x08\0\0\0", 8);
  const auto number = [&out](unsigned v, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<char>(v >> (8 * i)));
  };
  const unsigned entries[][4] = {{256, 3, 1, 1}, {257, 3, 1, 1},   {258, 3, 3, 134}, {259, 3, 1, 1},
                                 {262, 3, 1, 2}, {273, 4, 1, 140}, {277, 3, 1, 3},   {278, 3, 1, 1},
                                 {279, 4, 1, 3}, {284, 3, 1, 1}};
  number(10, 2);
  for (const auto& e : entries) {
    number(e[0], 2);
    number(e[1], 2);
    number(e[2], 4);
    number(e[3], 4);
  }
  number(0, 4);
  for (int i = 0; i < 3; ++i) number(8, 2);  // at 134: bits per sample
  for (const std::uint8_t v : {r, g, b}) out.push_back(static_cast<char>(v));
  return out;
}

TEST(ReadImage, ReadsTiffPictures) {
  const Scratch scratch;
  test::spill(scratch.path("a.tif"), tiff_file(0, 51, 255));
  const auto image = read_image(scratch.path("a.tif"), {SampleMeaning::kRaw, {}});
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->format, "tiff");
  EXPECT_EQ(image->plane[0](0, 0), 0.0f);
  EXPECT_EQ(image->plane[1](0, 0), static_cast<float>(51.0 / 255));
  EXPECT_EQ(image->plane[2](0, 0), 1.0f);
}

TEST(ReadImage, LimitsHoldBeforeMemoryIsTaken) {
  const Scratch scratch;
  write_8_bit(scratch.path("a.png"), 20, 30, PNG_FORMAT_GRAY, std::vector<std::uint8_t>(600));
  write_probe(scratch.path("a.exr"), test::made_up_planes(20, 30, 3), Imf::ZIP_COMPRESSION, 0, 0);
  test::spill(scratch.path("a.hdr"), radiance_file(20, 30, "\x80\x40\x20\x82"));
  for (const char* name : {"a.png", "a.exr", "a.hdr"}) {
    ImageReadOptions few;
    few.limits.max_pixels = 599;
    const auto image = read_image(scratch.path(name), few);
    ASSERT_FALSE(image) << name;
    EXPECT_EQ(image.error().code, ErrorCode::kLimit);
    EXPECT_EQ(image.error().message,
              scratch.path(name) + ": 20 x 30 pixels, the limit is 599 in all");
    ImageReadOptions narrow;
    narrow.limits.max_side = 29;
    EXPECT_FALSE(read_image(scratch.path(name), narrow)) << name;
  }
}

TEST(ReadImage, AHugeHeaderOfASmallFileIsRefused) {
  const Scratch scratch;
  test::spill(scratch.path("a.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 60000 +X 60000\n");
  const auto image = read_image(scratch.path("a.hdr"));
  ASSERT_FALSE(image);
  EXPECT_EQ(image.error().code, ErrorCode::kLimit) << image.error().message;
}

TEST(ReadImage, EveryTruncationIsAnError) {
  const Scratch scratch;
  std::vector<std::uint8_t> bytes;
  for (int i = 0; i < 8 * 6 * 3; ++i) bytes.push_back(static_cast<std::uint8_t>(i * 31));
  write_8_bit(scratch.path("a.png"), 8, 6, PNG_FORMAT_RGB, bytes);
  write_probe(scratch.path("a.exr"), test::made_up_planes(8, 6, 3), Imf::ZIP_COMPRESSION, 0, 0);
  for (const char* name : {"a.png", "a.exr"}) {
    const std::string whole = test::slurp(scratch.path(name));
    for (std::size_t n = 0; n < whole.size(); n += n < 64 || n + 32 > whole.size() ? 1 : 7) {
      test::spill(scratch.path("cut"), whole.substr(0, n));
      const auto image = read_image(scratch.path("cut"));
      ASSERT_FALSE(image) << name << " cut to " << n;
      EXPECT_EQ(image.error().code, ErrorCode::kBadInput);
    }
  }
}

TEST(ReadImage, SaysWhatItCannotRead) {
  const Scratch scratch;
  const auto missing = read_image(scratch.path("none.png"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::kIo);
  EXPECT_EQ(missing.error().message, scratch.path("none.png") + ": No such file or directory");
  test::spill(scratch.path("a.png"), "hello");
  const auto text = read_image(scratch.path("a.png"));
  ASSERT_FALSE(text);
  EXPECT_EQ(text.error().message,
            scratch.path("a.png") + ": not a PNG, OpenEXR, Radiance, JPEG or TIFF picture");
  const auto folder = read_image(scratch.path(""));
  ASSERT_FALSE(folder);
  EXPECT_EQ(folder.error().code, ErrorCode::kIo);
}

}  // namespace
}  // namespace pentimento

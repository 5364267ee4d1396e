// TIFF: what libtiff writes and what OpenCV reads is the truth; damage is one line.

#include <gtest/gtest.h>

#include "tests/formats/image/by_opencv.h"
#include "tests/formats/image/made_up_tiff.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::TiffShape;

class DecodeTiff : public testing::Test {
 protected:
  void write(const TiffShape& shape) {
    test::write_tiff(path_, shape,
                     [&](int x, int y, int c) { return test::made_up_sample(shape, x, y, c); });
  }
  std::string problem(const TiffShape& shape) {
    write(shape);
    return test::problem_with(path_);
  }
  Image read(const TiffShape& shape) {
    write(shape);
    Result<Image> image = read_image(path_, {SampleMeaning::kRaw, {}});
    EXPECT_TRUE(image) << image.error().message;
    return image ? std::move(*image) : Image();
  }
  /// The picture has the values that were written.
  void expect_written(const TiffShape& shape) {
    const Image image = read(shape);
    ASSERT_EQ(image.width, shape.width);
    ASSERT_EQ(image.height, shape.height);
    ASSERT_EQ(static_cast<int>(image.plane.size()), shape.samples);
    EXPECT_EQ(image.bits, shape.bits);
    const bool is_float = shape.format == SAMPLEFORMAT_IEEEFP;
    EXPECT_EQ(image.stored_float, is_float);
    const double scale = is_float ? 1 : 1.0 / ((1 << shape.bits) - 1);
    for (int c = 0; c < shape.samples; ++c)
      for (int y = 0; y < shape.height; ++y)
        for (int x = 0; x < shape.width; ++x)
          ASSERT_EQ(image.plane[static_cast<std::size_t>(c)](x, y),
                    static_cast<float>(test::made_up_sample(shape, x, y, c) * scale))
              << x << " " << y << " " << c;
  }

  const test::Scratch scratch_;
  const std::string path_ = scratch_.path("a.tif");
};

TEST_F(DecodeTiff, ReadsEverySampleInStripsAndTilesTogetherAndApart) {
  for (const int tile : {0, 16})
    for (const int planar : {PLANARCONFIG_CONTIG, PLANARCONFIG_SEPARATE})
      for (const int samples : {1, 2, 3, 4})
        for (const int bits : {8, 16, 32, 64})
          for (const bool big_endian : {false, true}) {
            SCOPED_TRACE(testing::Message() << tile << " " << planar << " " << samples << " "
                                            << bits << " " << big_endian);
            TiffShape shape;
            shape.tile = tile;
            shape.planar = planar;
            shape.samples = samples;
            shape.photometric = samples < 3 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
            shape.bits = bits;
            shape.format = bits > 16 ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT;
            shape.big_endian = big_endian;
            expect_written(shape);
          }
}

TEST_F(DecodeTiff, UnpacksWhatIsPacked) {
  for (const int compression : {COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS})
    for (const int tile : {0, 16}) {
      TiffShape shape;
      shape.compression = compression;
      shape.tile = tile;
      expect_written(shape);
    }
}

TEST_F(DecodeTiff, NamesItsPlanes) {
  TiffShape shape;
  EXPECT_EQ(read(shape).name, (std::vector<std::string>{"R", "G", "B"}));
  shape.samples = 4;
  EXPECT_EQ(read(shape).name, (std::vector<std::string>{"R", "G", "B", "A"}));
  shape.photometric = PHOTOMETRIC_MINISBLACK;
  shape.samples = 1;
  EXPECT_EQ(read(shape).name, (std::vector<std::string>{"Y"}));
  shape.samples = 2;
  EXPECT_EQ(read(shape).name, (std::vector<std::string>{"Y", "A"}));
}

TEST_F(DecodeTiff, IsWhatOpenCvReads) {
  for (const int bits : {8, 16})
    for (const int samples : {1, 3}) {
      TiffShape shape;
      shape.bits = bits;
      shape.samples = samples;
      shape.photometric = samples == 1 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
      shape.compression = COMPRESSION_LZW;
      test::expect_as_by_opencv(read(shape), path_);
    }
  for (const char* name :
       {"small.tiff", "deflated.tiff", "grey16.tiff", "palette.tiff", "jpeg-in.tiff"}) {
    SCOPED_TRACE(name);
    const std::string path =
        std::string(PENTIMENTO_SOURCE_DIR) + "/tests/corpus/fuzz/picture/" + name;
    const Result<Image> image = read_image(path, {SampleMeaning::kRaw, {}});
    ASSERT_TRUE(image) << image.error().message;
    test::expect_as_by_opencv(*image, path);
  }
}

// OpenCV writes floats this way: logarithms of XYZ. The white of its matrix lies 3e-4 beside ours.
TEST_F(DecodeTiff, LogarithmsOfLightAreLight) {
  const std::string path =
      std::string(PENTIMENTO_SOURCE_DIR) + "/tests/corpus/fuzz/picture/float.tiff";
  const Result<Image> image = read_image(path);
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_TRUE(image->stored_float);
  const test::OpenCvPicture truth = test::by_opencv(path);
  ASSERT_EQ(image->width, truth.width);
  ASSERT_EQ(image->height, truth.height);
  float most = 0;
  for (const float v : truth.samples) most = std::max(most, v);
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < truth.height; ++y)
      for (int x = 0; x < truth.width; ++x)
        ASSERT_NEAR(image->plane[static_cast<std::size_t>(c)](x, y), truth.at(x, y, 2 - c),
                    1e-3f * most);
}

TEST_F(DecodeTiff, WhiteMayBeNought) {
  TiffShape shape;
  shape.samples = 1;
  shape.photometric = PHOTOMETRIC_MINISWHITE;
  const Image image = read(shape);
  EXPECT_EQ(image.plane[0](2, 1),
            static_cast<float>(1 - test::made_up_sample(shape, 2, 1, 0) / 255));
}

TEST_F(DecodeTiff, LightIsLinear) {
  TiffShape shape;
  shape.samples = 4;
  read(shape);
  const Result<Image> light = read_image(path_);
  ASSERT_TRUE(light);
  // 0.5 of sRGB is 0.2140 of light; the code 31 is 0.01370. Alpha stays what it is.
  EXPECT_NEAR(light->plane[0](1, 0), 0.01370f, 1e-5f);
  EXPECT_EQ(light->plane[3](1, 0), static_cast<float>(test::made_up_sample(shape, 1, 0, 3) / 255));
}

// Each orientation in turn: where the first stored pixel is seen, and the next one of its row.
TEST_F(DecodeTiff, StandsUpright) {
  struct Seen {
    int orientation, x, y, next_x, next_y;
  };
  const int right = 19, bottom = 12;
  for (const Seen& seen :
       {Seen{1, 0, 0, 1, 0}, Seen{2, right, 0, right - 1, 0},
        Seen{3, right, bottom, right - 1, bottom}, Seen{4, 0, bottom, 1, bottom},
        Seen{5, 0, 0, 0, 1}, Seen{6, bottom, 0, bottom, 1},
        Seen{7, bottom, right, bottom, right - 1}, Seen{8, 0, right, 0, right - 1}}) {
    SCOPED_TRACE(seen.orientation);
    TiffShape shape;
    shape.orientation = seen.orientation;
    const Image image = read(shape);
    EXPECT_EQ(image.width, seen.orientation < 5 ? 20 : 13);
    EXPECT_EQ(image.height, seen.orientation < 5 ? 13 : 20);
    EXPECT_EQ(image.plane[1](seen.x, seen.y),
              static_cast<float>(test::made_up_sample(shape, 0, 0, 1) / 255));
    EXPECT_EQ(image.plane[1](seen.next_x, seen.next_y),
              static_cast<float>(test::made_up_sample(shape, 1, 0, 1) / 255));
  }
}

TEST_F(DecodeTiff, SaysWhatIsNotSupported) {
  TiffShape shape;
  shape.samples = 5;
  EXPECT_EQ(problem(shape), "5 channels are not supported");
  shape.samples = 1;
  EXPECT_EQ(problem(shape), "1 channels are not supported");
  shape = {};
  shape.format = SAMPLEFORMAT_INT;
  EXPECT_EQ(problem(shape), "signed samples are not supported");
  shape.format = SAMPLEFORMAT_COMPLEXINT;
  EXPECT_EQ(problem(shape), "complex samples are not supported");
  shape.format = SAMPLEFORMAT_IEEEFP;
  shape.bits = 16;
  EXPECT_EQ(problem(shape), "float samples of 16 bits are not supported");
  shape.format = SAMPLEFORMAT_UINT;
  shape.bits = 32;
  EXPECT_EQ(problem(shape), "whole samples of 32 bits are not supported");
}

TEST_F(DecodeTiff, ACutFileIsOneLine) {
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS}) {
    TiffShape shape;
    shape.compression = compression;
    read(shape);
    const std::string sound = test::slurp(path_);
    for (std::size_t n = 4; n < sound.size(); n += 3) {
      test::spill(path_, sound.substr(0, n));
      EXPECT_EQ(test::quiet_problem(path_).code, ErrorCode::kBadInput) << compression << " " << n;
    }
  }
}

std::uint32_t number_at(const std::string& bytes, std::size_t at, int size) {
  std::uint32_t number = 0;
  for (int i = 0; i < size; ++i)
    number |= std::uint32_t{static_cast<std::uint8_t>(bytes[at + static_cast<std::size_t>(i)])}
              << (8 * i);
  return number;
}

/// A little-endian TIFF with a second copy of its strips or tiles, which lies behind all else and
/// is the one that its directory names.
std::string with_pixels_last(std::string bytes) {
  constexpr std::uint32_t kStripOffsets = 273, kTileOffsets = 324;
  const std::size_t directory = number_at(bytes, 4, 4);
  const auto moved = static_cast<std::uint32_t>(bytes.size()) - 8;  // they begin behind the header
  for (std::uint32_t i = 0; i < number_at(bytes, directory, 2); ++i) {
    const std::size_t entry = directory + 2 + 12 * std::size_t{i};
    const std::uint32_t tag = number_at(bytes, entry, 2);
    if (tag != kStripOffsets && tag != kTileOffsets) continue;
    const int size = number_at(bytes, entry + 2, 2) == 3 ? 2 : 4;  // SHORT or LONG
    const std::uint32_t count = number_at(bytes, entry + 4, 4);
    const std::size_t first =
        count * static_cast<std::uint32_t>(size) <= 4 ? entry + 8 : number_at(bytes, entry + 8, 4);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t at = first + k * static_cast<std::size_t>(size);
      const std::uint32_t offset = number_at(bytes, at, size) + moved;
      for (int b = 0; b < size; ++b)
        bytes[at + static_cast<std::size_t>(b)] = static_cast<char>(offset >> (8 * b));
    }
  }
  return bytes + bytes.substr(8, directory - 8);
}

TEST_F(DecodeTiff, PixelsThatAreCutAreOneLine) {
  for (const int compression :
       {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS})
    for (const int tile : {0, 16}) {
      TiffShape shape;
      shape.compression = compression;
      shape.tile = tile;
      read(shape);
      const std::string plain = test::slurp(path_), sound = with_pixels_last(plain);
      test::spill(path_, sound);
      ASSERT_TRUE(read_image(path_)) << compression << " " << tile;
      // The last byte of a packed strip may be no more than its end.
      for (std::size_t n = plain.size(); n + 2 < sound.size(); n += 7) {
        test::spill(path_, sound.substr(0, n));
        EXPECT_EQ(test::quiet_problem(path_).code, ErrorCode::kBadInput)
            << compression << " " << tile << " " << n;
      }
    }
}

// libtiff does not look at the checksums of zlib, so damage shows where it cannot be unpacked.
TEST_F(DecodeTiff, AStripThatCannotBeUnpackedIsOneLine) {
  for (const int compression : {COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE})
    for (const int tile : {0, 16}) {
      TiffShape shape;
      shape.compression = compression;
      shape.tile = tile;
      read(shape);
      std::string damaged = test::slurp(path_);
      damaged[8] = static_cast<char>(damaged[8] ^ 0x41);  // the first strip or tile begins here
      test::spill(path_, damaged);
      EXPECT_EQ(test::quiet_problem(path_).code, ErrorCode::kBadInput)
          << compression << " " << tile;
    }
}

TEST_F(DecodeTiff, NoDamagePrintsAnything) {
  for (const char* name : {"small.tiff", "deflated.tiff", "palette.tiff", "jpeg-in.tiff"}) {
    const std::string sound =
        test::slurp(std::string(PENTIMENTO_SOURCE_DIR) + "/tests/corpus/fuzz/picture/" + name);
    ASSERT_FALSE(sound.empty());
    for (std::size_t at = 4; at < sound.size(); ++at) {
      std::string damaged = sound;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x41);
      test::spill(path_, damaged);
      test::quiet_problem(path_);
    }
  }
}

TEST_F(DecodeTiff, SizesAreLimitedBeforeMemoryIsTaken) {
  TiffShape shape;
  read(shape);
  ImageReadOptions few;
  few.limits.max_pixels = 259;
  EXPECT_EQ(test::problem_with(path_, few), "20 x 13 pixels, the limit is 259 in all");
  few.limits = {12, 1000};
  EXPECT_EQ(test::quiet_problem(path_, few).code, ErrorCode::kLimit);
}

}  // namespace
}  // namespace pentimento

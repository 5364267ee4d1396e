#include "formats/exr/exr_writer.h"

#include <gtest/gtest.h>

#include <limits>

#include "formats/image/read_image.h"
#include "formats/io/provenance.h"
#include "formats/io/sha256.h"
#include "tests/formats/scratch.h"

namespace pentimento {
namespace {

using test::Scratch;

const std::vector<std::string> kNames = {"R", "G", "B", "height.Y", "albedo.R"};

Result<Published> write_exr(const std::string& path, const std::vector<Field<float>>& planes,
                            ExrOptions options, int strip_rows) {
  options.width = planes[0].width();
  options.height = planes[0].height();
  options.channels.assign(kNames.begin(), kNames.begin() + static_cast<int>(planes.size()));
  auto file = create_exr(path, options);
  if (!file) return file.error();
  if (auto written = test::write_strips(**file, planes, options.channels, strip_rows); !written)
    return written.error();
  return (*file)->finish();
}

TEST(ExrWriter, FloatChannelsComeBackBitForBit) {
  const Scratch scratch;
  const auto planes = test::made_up_planes(67, 81, 5);
  ExrOptions options;
  options.full_float = true;
  ASSERT_TRUE(write_exr(scratch.path("a.exr"), planes, options, 13));
  const auto image = read_image(scratch.path("a.exr"));
  ASSERT_TRUE(image) << image.error().message;
  EXPECT_EQ(image->bits, 32);
  for (std::size_t c = 0; c < planes.size(); ++c) {
    const Field<float>* plane = image->find(kNames[c]);
    ASSERT_NE(plane, nullptr) << kNames[c];
    for (int y = 0; y < 81; ++y)
      for (int x = 0; x < 67; ++x) ASSERT_EQ((*plane)(x, y), planes[c](x, y));
  }
}

TEST(ExrWriter, HalfChannelsAreTheNearestHalf) {
  const Scratch scratch;
  const auto planes = test::made_up_planes(67, 81, 3);
  ASSERT_TRUE(write_exr(scratch.path("a.exr"), planes, {}, 32));
  const auto image = read_image(scratch.path("a.exr"));
  ASSERT_TRUE(image);
  EXPECT_EQ(image->bits, 16);
  for (int y = 0; y < 81; ++y)
    for (int x = 0; x < 67; ++x) {
      const float v = planes[0](x, y);
      // Half has 11 significant bits; below 2^-14 its steps are 2^-24.
      ASSERT_NEAR((*image->find("R"))(x, y), v, std::abs(v) * 0x1p-11f + 0x1p-25f);
    }
}

TEST(ExrWriter, FullFloatsAreCompressedByRuns) {
  const Scratch scratch;
  ExrOptions options;
  options.full_float = true;
  ASSERT_TRUE(write_exr(scratch.path("a.exr"), test::made_up_planes(20, 10, 4), options, 10));
  const auto [status, text] = test::run("exrheader " + scratch.path("a.exr"));
  EXPECT_EQ(status, 0) << text;
  EXPECT_NE(text.find("compression (type compression): run-length"), std::string::npos) << text;
}

TEST(ExrWriter, ExrheaderFindsWhatWeSaid) {
  const Scratch scratch;
  ExrOptions options;
  options.dpi = 300;
  options.provenance = {{"log_sha256", "abc"}, {"compression", "said by us"}};
  ASSERT_TRUE(write_exr(scratch.path("a.exr"), test::made_up_planes(20, 10, 4), options, 10));
  const auto [status, text] = test::run("exrheader " + scratch.path("a.exr"));
  EXPECT_EQ(status, 0) << text;
  for (const char* line : {"height.Y, 16-bit floating-point", "compression (type compression): piz",
                           "red   (0.64 0.33)", "white (0.3127 0.329)",
                           "xDensity (type float): 300", "log_sha256 (type string): \"abc\"",
                           "pentimento.compression (type string): \"said by us\""})
    EXPECT_NE(text.find(line), std::string::npos) << line << "\n" << text;
  const auto described = describe_file(scratch.path("a.exr"));
  ASSERT_TRUE(described);
  EXPECT_EQ(provenance_value(described->provenance, "compression"), "said by us");
  EXPECT_EQ(provenance_value(described->provenance, "log_sha256"), "abc");
  EXPECT_EQ(described->dpi, 300);
}

TEST(ExrWriter, PostersAreTiled) {
  const Scratch scratch;
  const auto planes = test::made_up_planes(kLongestScanlineSide + 100, 300, 3);  // 33 x 2 tiles
  ExrOptions options;
  options.full_float = true;
  const auto first = write_exr(scratch.path("a.exr"), planes, options, 70);
  options.threads = 3;
  const auto second = write_exr(scratch.path("b.exr"), planes, options, 300);
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->sha256, second->sha256);
  EXPECT_NE(test::run("exrheader " + scratch.path("a.exr")).second.find("tile size 256 by 256"),
            std::string::npos);
  const auto image = read_image(scratch.path("a.exr"));
  ASSERT_TRUE(image) << image.error().message;
  for (std::size_t c = 0; c < planes.size(); ++c)
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < image->width; ++x)
        ASSERT_EQ((*image->find(kNames[c]))(x, y), planes[c](x, y));
}

TEST(ExrWriter, BytesDependNeitherOnThreadsNorOnStrips) {
  const Scratch scratch;
  const auto planes = test::made_up_planes(120, 200, 3);
  const auto first = write_exr(scratch.path("a.exr"), planes, {}, 200);
  ASSERT_TRUE(first);
  for (const int threads : {2, 7})
    for (const int rows : {1, 64}) {
      ExrOptions options;
      options.threads = threads;
      const auto other = write_exr(scratch.path("b.exr"), planes, options, rows);
      ASSERT_TRUE(other);
      EXPECT_EQ(other->sha256, first->sha256) << threads << " threads, strips of " << rows;
    }
}

TEST(ExrWriter, TheHashIsThatOfTheFile) {
  const Scratch scratch;
  const auto published = write_exr(scratch.path("a.exr"), test::made_up_planes(9, 9, 3), {}, 9);
  ASSERT_TRUE(published);
  EXPECT_EQ(published->sha256, sha256_hex(test::slurp(scratch.path("a.exr"))));
}

TEST(ExrWriter, BrightnessBeyondHalfIsItsLargestNumber) {
  const Scratch scratch;
  auto planes = test::made_up_planes(3, 1, 3);
  planes[0](0, 0) = 1e9f;
  planes[0](1, 0) = std::numeric_limits<float>::infinity();
  ASSERT_TRUE(write_exr(scratch.path("a.exr"), planes, {}, 1));
  const auto image = read_image(scratch.path("a.exr"));
  EXPECT_EQ((*image->find("R"))(0, 0), 65504.0f);
  EXPECT_EQ((*image->find("R"))(1, 0), 65504.0f);
}

TEST(ExrWriter, ANanIsAnErrorAndLeavesNoFile) {
  const Scratch scratch;
  auto planes = test::made_up_planes(3, 2, 3);
  planes[2](1, 1) = std::numeric_limits<float>::quiet_NaN();
  const auto result = write_exr(scratch.path("a.exr"), planes, {}, 1);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kNonFinite);
  EXPECT_EQ(scratch.files(), 0u);
}

TEST(ExrWriter, RefusesStandardOutput) {
  ExrOptions options;
  options.width = options.height = 1;
  options.channels = {"Y"};
  const auto file = create_exr("-", options);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace pentimento

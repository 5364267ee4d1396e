#pragma once
// The truth from outside for pictures: the same file through OpenCV's decoder.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "formats/image/module_function.h"
#include "formats/image/read_image.h"
#include "tests/formats/image/opencv/opencv_reader.h"

namespace pentimento::test {

/// Stored samples as OpenCV gives them, channels in its order (B, G, R, or grey).
struct OpenCvPicture {
  int width = 0, height = 0, channels = 0;
  std::vector<float> samples;

  float at(int x, int y, int channel) const {
    return samples[static_cast<std::size_t>((y * width + x) * channels + channel)];
  }
};

/// An empty picture if OpenCV does not read it.
inline OpenCvPicture by_opencv(const std::string& path) {
  const auto read = image::module_function<decltype(pentimento_read_picture)>(
      "pentimento_opencv_reader.so", "pentimento_read_picture");
  OpenCvPicture picture;
  if (!read) return picture;
  const auto size = [](void* owner, int width, int height, int channels, int, int) {
    auto& to = *static_cast<OpenCvPicture*>(owner);
    to.width = width;
    to.height = height;
    to.channels = channels;
    return 0;
  };
  const auto row = [](void* owner, int, const float* samples) {
    auto& to = *static_cast<OpenCvPicture*>(owner);
    to.samples.insert(to.samples.end(), samples, samples + to.width * to.channels);
  };
  const PentimentoPicture to = {&picture, size, row, [](void*, const char*) {}};
  return read->call(path.c_str(), &to) == 0 ? picture : OpenCvPicture{};
}

/// `image` has the bits that OpenCV reads from `path`; it holds stored values.
inline void expect_as_by_opencv(const Image& image, const std::string& path) {
  const OpenCvPicture truth = by_opencv(path);
  ASSERT_EQ(image.width, truth.width);
  ASSERT_EQ(image.height, truth.height);
  ASSERT_EQ(static_cast<int>(image.plane.size()), truth.channels);
  for (int c = 0; c < truth.channels; ++c)
    for (int y = 0; y < truth.height; ++y)
      for (int x = 0; x < truth.width; ++x)
        ASSERT_EQ(image.plane[static_cast<std::size_t>(c)](x, y),
                  truth.at(x, y, truth.channels - 1 - c))
            << x << " " << y << " " << c;
}

/// What `read_image` says of a file that is not sound: one line that begins with its name, and
/// nothing on standard error.
inline Error quiet_problem(const std::string& path, const ImageReadOptions& options = {}) {
  testing::internal::CaptureStderr();
  const Result<Image> image = read_image(path, options);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  if (image) return {ErrorCode::kUsage, "read without an error"};
  const std::string& said = image.error().message;
  EXPECT_TRUE(said.starts_with(path + ": ")) << said;
  EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  return image.error();
}

/// The message without the name of the file.
inline std::string problem_with(const std::string& path, const ImageReadOptions& options = {}) {
  const std::string said = quiet_problem(path, options).message;
  return said.starts_with(path) ? said.substr(path.size() + 2) : said;
}

}  // namespace pentimento::test

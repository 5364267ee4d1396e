#include <fmt/format.h>

#include <vector>

#include "core/optics/srgb.h"
#include "formats/image/decode.h"
#include "formats/image/module_function.h"
#include "formats/image/picture_module.h"
#include "formats/image/tiff_header.h"

namespace pentimento::image {

namespace {

struct Reading {
  const std::string& path;
  const ImageReadOptions& options;
  Image image;
  bool decode_light = false;
  Error error;
};

std::vector<std::string> names_of(int channels) {
  switch (channels) {
    case 1:
      return {"Y"};
    case 3:
      return {"B", "G", "R"};
    case 4:
      return {"B", "G", "R", "A"};
    default:
      return {};
  }
}

int take_size(void* owner, int width, int height, int channels, int bits, int is_float) {
  Reading& reading = *static_cast<Reading*>(owner);
  const Result<void> fits = check_size(reading.path, width, height, reading.options.limits);
  if (!fits) {
    reading.error = fits.error();
    return 1;
  }
  Image& image = reading.image;
  image.name = names_of(channels);
  if (image.name.empty()) {
    reading.error = {ErrorCode::kBadInput,
                     fmt::format("{}: {} channels are not supported", reading.path, channels)};
    return 1;
  }
  image.width = width;
  image.height = height;
  image.bits = bits;
  image.stored_float = is_float != 0;
  reading.decode_light = is_float == 0 && reading.options.meaning == SampleMeaning::kLight;
  for (int c = 0; c < channels; ++c) image.plane.emplace_back(width, height);
  return 0;
}

void take_row(void* owner, int y, const float* samples) {
  Reading& reading = *static_cast<Reading*>(owner);
  Image& image = reading.image;
  const std::size_t channels = image.plane.size();
  for (std::size_t c = 0; c < channels; ++c) {
    const bool light = reading.decode_light && image.name[c] != "A";
    float* out = image.plane[c].row(y);
    for (int x = 0; x < image.width; ++x) {
      const float v = samples[static_cast<std::size_t>(x) * channels + c];
      out[x] = light ? static_cast<float>(srgb_to_linear(static_cast<double>(v))) : v;
    }
  }
}

void take_failure(void* owner, const char* message) {
  Reading& reading = *static_cast<Reading*>(owner);
  const std::string line = first_line(message);
  // OpenCV throws for a size beyond its limits, and for nothing else on this path.
  const bool too_large = line.find("CV_IO_MAX_IMAGE") != std::string::npos;
  reading.error = {too_large ? ErrorCode::kLimit : ErrorCode::kBadInput,
                   reading.path + ": " + (too_large ? "more pixels than the limit" : line)};
}

/// Red before blue, as elsewhere.
void order_planes(Image& image) {
  if (image.plane.size() < 3) return;
  std::swap(image.name[0], image.name[2]);
  swap(image.plane[0], image.plane[2]);
}

}  // namespace

Result<Image> decode_tiff(const std::string& path, const ImageReadOptions& options) {
  if (const Result<void> fits = check_tiff_header(path, options.limits); !fits) return fits.error();
  static const auto read =
      module_function<decltype(pentimento_read_picture)>(kPictureModule, "pentimento_read_picture");
  if (!read) return read.error();
  Reading reading{path, options, {}, false, {}};
  const PentimentoPicture to = {&reading, take_size, take_row, take_failure};
  if (read->call(path.c_str(), &to) != 0) return reading.error;
  order_planes(reading.image);
  reading.image.format = "tiff";
  return std::move(reading.image);
}

}  // namespace pentimento::image

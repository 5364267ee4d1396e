#include "formats/image/read_image.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "formats/color/converted_file.h"
#include "formats/image/decode.h"

namespace pentimento {

namespace {

/// "png", "exr", "hdr", "jpeg", "tiff" by the first bytes; empty if none of them.
std::string format_of(std::string_view head) {
  using namespace std::string_view_literals;
  if (head.starts_with("\x89PNG\r\n\x1A\n"sv)) return "png";
  if (head.starts_with("\x76\x2F\x31\x01"sv)) return "exr";
  if (head.starts_with("#?"sv)) return "hdr";
  if (head.starts_with("\xFF\xD8\xFF"sv)) return "jpeg";
  // The second pair is of files beyond 4 GB.
  for (const std::string_view start : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
    if (head.starts_with(start)) return "tiff";
  return "";
}

Result<std::string> read_head(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(errno))};
  char bytes[8];
  const std::size_t n = std::fread(bytes, 1, sizeof bytes, file);
  const int problem = std::ferror(file) != 0 ? errno : 0;
  std::fclose(file);
  if (problem != 0)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(problem))};
  return std::string(bytes, n);
}

/// (R + G + B) / 3, or Y.
Field<float> grey_of(const Image& image) {
  if (const Field<float>* grey = image.find("Y")) return grey->clone();
  const Field<float>& r = *image.find("R");
  const Field<float>& g = *image.find("G");
  const Field<float>& b = *image.find("B");
  Field<float> mean(image.width, image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) mean(x, y) = ((r(x, y) + g(x, y)) + b(x, y)) / 3;
  return mean;
}

Result<void> check_has_colour(const Image& image, const std::string& path) {
  if (image.find("Y") != nullptr) return {};
  if (image.find("R") != nullptr && image.find("G") != nullptr && image.find("B") != nullptr)
    return {};
  return Error{ErrorCode::kBadInput, path + ": has neither R, G, B nor Y"};
}

}  // namespace

namespace image {
Result<void> check_size(const std::string& path, std::int64_t width, std::int64_t height,
                        const ImageLimits& limits) {
  if (width <= 0 || height <= 0)
    return Error{ErrorCode::kBadInput, fmt::format("{}: {} x {} pixels", path, width, height)};
  if (width > limits.max_side || height > limits.max_side)
    return Error{ErrorCode::kLimit, fmt::format("{}: {} x {} pixels, the limit is {} a side", path,
                                                width, height, limits.max_side)};
  if (width > limits.max_pixels / height)
    return Error{ErrorCode::kLimit, fmt::format("{}: {} x {} pixels, the limit is {} in all", path,
                                                width, height, limits.max_pixels)};
  return {};
}
}  // namespace image

const Field<float>* Image::find(const std::string& plane_name) const {
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] == plane_name) return &plane[i];
  return nullptr;
}

Result<Image> read_image(const std::string& path, const ImageReadOptions& options) {
  const Result<std::string> head = read_head(path);
  if (!head) return head.error();
  const std::string format = format_of(*head);
  if (format.empty())
    return Error{ErrorCode::kBadInput,
                 path + ": not a PNG, OpenEXR, Radiance, JPEG or TIFF picture"};
  if (format == "png") return image::decode_png(path, options);
  if (format == "exr") return image::decode_exr(path, options);
  if (format == "hdr") return image::decode_hdr(path, options);
  if (format == "jpeg") return image::decode_jpeg(path, options);
  return image::decode_tiff(path, options);
}

void to_rec709(Image& image) {
  if (image.profile == ColorProfile::kSrgb) return;
  const ColorMatrix m = between(image.profile, ColorProfile::kSrgb);
  image.profile = ColorProfile::kSrgb;
  for (const std::array<std::size_t, 3>& rgb : light_channels(image.name))
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x) {
        std::array<double, 3> v{};
        for (std::size_t i = 0; i < 3; ++i) v[i] = static_cast<double>(image.plane[rgb[i]](x, y));
        for (std::size_t i = 0; i < 3; ++i)
          image.plane[rgb[i]](x, y) =
              static_cast<float>((m[i][0] * v[0] + m[i][1] * v[1]) + m[i][2] * v[2]);
      }
}

Result<std::array<Field<float>, 3>> read_rgb(const std::string& path, const ImageLimits& limits) {
  Result<Image> image = read_image(path, {SampleMeaning::kLight, limits});
  if (!image) return image.error();
  if (const Result<void> fine = check_has_colour(*image, path); !fine) return fine.error();
  to_rec709(*image);
  std::array<Field<float>, 3> rgb;
  const std::array<const char*, 3> names = {"R", "G", "B"};
  for (std::size_t c = 0; c < 3; ++c) {
    const Field<float>* plane = image->find(names[c]);
    rgb[c] = (plane != nullptr ? plane : image->find("Y"))->clone();
  }
  return rgb;
}

Result<Field<float>> read_grey(const std::string& path, const ImageLimits& limits) {
  const Result<Image> image = read_image(path, {SampleMeaning::kRaw, limits});
  if (!image) return image.error();
  if (const Result<void> fine = check_has_colour(*image, path); !fine) return fine.error();
  return grey_of(*image);
}

Result<Field<float>> read_tip(const std::string& path, const ImageLimits& limits) {
  const Result<Image> image = read_image(path, {SampleMeaning::kRaw, limits});
  if (!image) return image.error();
  if (const Field<float>* alpha = image->find("A")) return alpha->clone();
  if (const Result<void> fine = check_has_colour(*image, path); !fine) return fine.error();
  return grey_of(*image);
}

}  // namespace pentimento

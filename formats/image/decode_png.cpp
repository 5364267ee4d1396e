#include <fmt/format.h>
#include <png.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

#include "formats/image/decode.h"
#include "formats/png/profile_chunk.h"

namespace pentimento::image {

namespace {

/// libpng reports errors by longjmp. Everything that it may leave half done lives here, outside the
/// functions that call libpng.
struct PngReading {
  std::FILE* file = nullptr;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string message;
  std::vector<std::uint8_t> bytes;
  std::vector<png_bytep> rows;

  ~PngReading() {
    if (png != nullptr) png_destroy_read_struct(&png, info != nullptr ? &info : nullptr, nullptr);
    if (file != nullptr) std::fclose(file);
  }
};

void fail(png_structp png, png_const_charp what) {
  static_cast<PngReading*>(png_get_error_ptr(png))->message = what;
  png_longjmp(png, 1);
}

/// Reads up to the first pixel row; false: `message` says why.
bool read_header(PngReading& in, const ImageLimits& limits) {
  if (setjmp(png_jmpbuf(in.png)) != 0) return false;
  png_init_io(in.png, in.file);
  const auto side = static_cast<png_uint_32>(limits.max_side);
  png_set_user_limits(in.png, side, side);
  // libpng would refuse the picture for a doubtful profile: as an unknown chunk it does not look.
  png_set_keep_unknown_chunks(in.png, PNG_HANDLE_CHUNK_ALWAYS,
                              reinterpret_cast<png_const_bytep>("iCCP"), 1);
  png_read_info(in.png, in.info);
  return true;
}

/// Palettes and 1, 2, 4 bit greys become 8 bit; transparency becomes alpha; rows come whole.
bool read_pixels(PngReading& in) {
  if (setjmp(png_jmpbuf(in.png)) != 0) return false;
  png_set_expand(in.png);
  png_set_interlace_handling(in.png);
  png_read_update_info(in.png, in.info);
  const std::size_t pitch = png_get_rowbytes(in.png, in.info);
  const std::size_t height = png_get_image_height(in.png, in.info);
  in.bytes.resize(pitch * height);
  in.rows.resize(height);
  for (std::size_t y = 0; y < height; ++y) in.rows[y] = in.bytes.data() + y * pitch;
  png_read_image(in.png, in.rows.data());
  png_read_end(in.png, in.info);
  return true;
}

std::vector<std::string> plane_names(int channels) {
  switch (channels) {
    case 1:
      return {"Y"};
    case 2:
      return {"Y", "A"};
    case 3:
      return {"R", "G", "B"};
    default:
      return {"R", "G", "B", "A"};
  }
}

/// What the picture says about its colours.
void take_profile(const PngReading& in, Image& image) {
  png_unknown_chunkp chunks = nullptr;
  const int count = png_get_unknown_chunks(in.png, in.info, &chunks);
  for (int i = 0; i < count; ++i) {
    if (std::string_view(reinterpret_cast<const char*>(chunks[i].name), 4) != "iCCP") continue;
    const IccDescription found = png::describe_iccp({chunks[i].data, chunks[i].size});
    image.profile_title = found.title;
    image.profile = found.profile.value_or(ColorProfile::kSrgb);
    image.unknown_profile = !found.profile;
    return;
  }
  if (png_get_valid(in.png, in.info, PNG_INFO_sRGB) != 0)
    image.profile_title = profile_title(ColorProfile::kSrgb);
}

/// Value of each code.
std::vector<float> code_values(int max_code, bool light, ColorProfile profile) {
  std::vector<float> values;
  for (int c = 0; c <= max_code; ++c) {
    const double v = static_cast<double>(c) / max_code;
    values.push_back(static_cast<float>(light ? decode_transfer(profile, v) : v));
  }
  return values;
}

Image to_image(const PngReading& in, SampleMeaning meaning) {
  const int channels = png_get_channels(in.png, in.info);
  const int sample_bytes = png_get_bit_depth(in.png, in.info) / 8;
  Image image;
  image.width = static_cast<int>(png_get_image_width(in.png, in.info));
  image.height = static_cast<int>(png_get_image_height(in.png, in.info));
  image.format = "png";
  image.bits = sample_bytes * 8;
  image.name = plane_names(channels);
  take_profile(in, image);
  const int max_code = sample_bytes == 1 ? 255 : 65535;
  const std::vector<float> raw = code_values(max_code, false, image.profile);
  const std::vector<float> light =
      code_values(max_code, meaning == SampleMeaning::kLight, image.profile);
  for (int c = 0; c < channels; ++c) {
    const std::vector<float>& values = image.name[static_cast<std::size_t>(c)] == "A" ? raw : light;
    Field<float>& plane = image.plane.emplace_back(image.width, image.height);
    for (int y = 0; y < image.height; ++y) {
      const std::uint8_t* from = in.rows[static_cast<std::size_t>(y)] + c * sample_bytes;
      for (int x = 0; x < image.width; ++x, from += channels * sample_bytes)
        plane(x, y) =
            values[sample_bytes == 1 ? from[0] : static_cast<std::size_t>(from[0] << 8 | from[1])];
    }
  }
  return image;
}

}  // namespace

Result<Image> decode_png(const std::string& path, const ImageReadOptions& options) {
  PngReading in;
  in.file = std::fopen(path.c_str(), "rbe");
  if (in.file == nullptr)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(errno))};
  // Warnings count as errors: libpng warns of damage and then hides it.
  in.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &in, fail, fail);
  in.info = in.png == nullptr ? nullptr : png_create_info_struct(in.png);
  if (in.info == nullptr) return Error{ErrorCode::kLimit, path + ": no memory to read it"};
  if (!read_header(in, options.limits))
    return Error{ErrorCode::kBadInput, path + ": " + in.message};
  const Result<void> fits = check_size(path, png_get_image_width(in.png, in.info),
                                       png_get_image_height(in.png, in.info), options.limits);
  if (!fits) return fits.error();
  if (!read_pixels(in)) return Error{ErrorCode::kBadInput, path + ": " + in.message};
  return to_image(in, options.meaning);
}

}  // namespace pentimento::image

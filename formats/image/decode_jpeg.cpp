#include <fmt/format.h>

#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
// libjpeg's headers need what stands above, and the second needs the first.
#include <jpeglib.h>
//
#include <jerror.h>

#include <array>
#include <utility>

#include "core/optics/srgb.h"
#include "formats/image/decode.h"

namespace pentimento::image {

namespace {

/// Of a progressive picture. Encoders write about ten. Each takes the time of a plain picture,
/// however few bytes it has in the file.
constexpr int kMostScans = 100;
/// Some cameras fill up the last words before the end mark. More bytes there are damage.
constexpr int kMostPaddingBytes = 16;
constexpr int kEndMark = 0xD9;

/// libjpeg reports errors by a call that must not return. Everything that it may leave half done
/// lives here, outside the functions that call it.
struct JpegReading {
  JpegReading() = default;
  JpegReading(const JpegReading&) = delete;
  JpegReading& operator=(const JpegReading&) = delete;
  ~JpegReading() {
    jpeg_destroy_decompress(&jpeg);
    if (file != nullptr) std::fclose(file);
  }

  std::FILE* file = nullptr;
  jpeg_decompress_struct jpeg = {};
  jpeg_error_mgr messages = {};
  jpeg_progress_mgr progress = {};
  std::jmp_buf back = {};
  Error problem;
  std::vector<JSAMPLE> row;
};

[[noreturn]] void fail(j_common_ptr jpeg) {
  JpegReading& in = *static_cast<JpegReading*>(jpeg->client_data);
  std::array<char, JMSG_LENGTH_MAX> text{};
  jpeg->err->format_message(jpeg, text.data());
  const bool no_memory = jpeg->err->msg_code == JERR_OUT_OF_MEMORY;
  in.problem = {no_memory ? ErrorCode::kLimit : ErrorCode::kBadInput, text.data()};
  std::longjmp(in.back, 1);
}

/// Warnings count as errors: libjpeg warns of what is missing and then makes it up. Two of them
/// tell of nothing missing: a revision that is newer than the library, and padding.
void warn(j_common_ptr jpeg, int level) {
  if (level >= 0) return;
  const jpeg_error_mgr& said = *jpeg->err;
  if (said.msg_code == JWRN_JFIF_MAJOR) return;
  if (said.msg_code == JWRN_EXTRANEOUS_DATA && said.msg_parm.i[0] <= kMostPaddingBytes &&
      said.msg_parm.i[1] == kEndMark)
    return;
  fail(jpeg);
}

void count_scans(j_common_ptr jpeg) {
  JpegReading& in = *static_cast<JpegReading*>(jpeg->client_data);
  if (in.jpeg.input_scan_number <= kMostScans) return;
  in.problem = {ErrorCode::kLimit, fmt::format("more than {} scans, the limit", kMostScans)};
  std::longjmp(in.back, 1);
}

/// Reads up to the first scan; false: `problem` says why.
bool read_header(JpegReading& in) {
  in.jpeg.err = jpeg_std_error(&in.messages);
  in.messages.error_exit = fail;
  in.messages.emit_message = warn;
  in.jpeg.client_data = &in;
  if (setjmp(in.back) != 0) return false;
  jpeg_create_decompress(&in.jpeg);
  in.progress.progress_monitor = count_scans;
  in.jpeg.progress = &in.progress;
  jpeg_stdio_src(&in.jpeg, in.file);
  jpeg_read_header(&in.jpeg, TRUE);
  return true;
}

/// From here on the library takes memory for the picture.
bool begin_rows(JpegReading& in, J_COLOR_SPACE colors) {
  if (setjmp(in.back) != 0) return false;
  in.jpeg.out_color_space = colors;
  jpeg_start_decompress(&in.jpeg);
  return true;
}

/// The next row of the picture comes into `row`.
bool read_row(JpegReading& in) {
  if (setjmp(in.back) != 0) return false;
  JSAMPROW row = in.row.data();
  jpeg_read_scanlines(&in.jpeg, &row, 1);
  return true;
}

bool read_end(JpegReading& in) {
  if (setjmp(in.back) != 0) return false;
  jpeg_finish_decompress(&in.jpeg);
  return true;
}

/// Red, green and blue of a pixel of four inks. Adobe's programs store how much of each ink is not
/// there, and mark the file; without the mark the codes are amounts of ink.
std::array<JSAMPLE, 3> rgb_of_inks(const JSAMPLE* inks, bool by_adobe) {
  const auto bare = [by_adobe](JSAMPLE ink) { return by_adobe ? ink : 255 - ink; };
  const int black = bare(inks[3]);
  std::array<JSAMPLE, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<JSAMPLE>(black - (((255 - bare(inks[c])) * black) >> 8));
  return rgb;
}

void take_row(const JpegReading& in, int y, const std::array<float, 256>& values, Image& image) {
  const auto channels = static_cast<std::size_t>(in.jpeg.out_color_components);
  const bool inks = in.jpeg.out_color_space == JCS_CMYK;
  const bool by_adobe = in.jpeg.saw_Adobe_marker != FALSE;
  for (int x = 0; x < image.width; ++x) {
    const JSAMPLE* codes = in.row.data() + static_cast<std::size_t>(x) * channels;
    std::array<JSAMPLE, 3> rgb{};
    if (inks) {
      rgb = rgb_of_inks(codes, by_adobe);
      codes = rgb.data();
    }
    for (std::size_t c = 0; c < image.plane.size(); ++c) image.plane[c](x, y) = values[codes[c]];
  }
}

/// Value of each code.
std::array<float, 256> code_values(SampleMeaning meaning) {
  std::array<float, 256> values{};
  for (std::size_t code = 0; code < values.size(); ++code) {
    values[code] = static_cast<float>(static_cast<double>(code) * (1.0 / 255));
    if (meaning == SampleMeaning::kLight)
      values[code] = static_cast<float>(srgb_to_linear(static_cast<double>(values[code])));
  }
  return values;
}

Result<J_COLOR_SPACE> colors_of(int components) {
  switch (components) {
    case 1:
      return JCS_GRAYSCALE;
    case 3:
      return JCS_RGB;
    case 4:
      return JCS_CMYK;
    default:
      return Error{ErrorCode::kBadInput, fmt::format("{} channels are not supported", components)};
  }
}

Error problem_of(const std::string& path, const JpegReading& in) {
  if (std::ferror(in.file) != 0) return {ErrorCode::kIo, path + ": cannot be read"};
  return {in.problem.code, path + ": " + in.problem.message};
}

}  // namespace

Result<Image> decode_jpeg(const std::string& path, const ImageReadOptions& options) {
  JpegReading in;
  in.file = std::fopen(path.c_str(), "rbe");
  if (in.file == nullptr)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(errno))};
  if (!read_header(in)) return problem_of(path, in);
  const Result<void> fits =
      check_size(path, in.jpeg.image_width, in.jpeg.image_height, options.limits);
  if (!fits) return fits.error();
  const Result<J_COLOR_SPACE> colors = colors_of(in.jpeg.num_components);
  if (!colors) return Error{colors.error().code, path + ": " + colors.error().message};
  Image image;
  image.width = static_cast<int>(in.jpeg.image_width);
  image.height = static_cast<int>(in.jpeg.image_height);
  image.format = "jpeg";
  image.name = *colors == JCS_GRAYSCALE ? std::vector<std::string>{"Y"}
                                        : std::vector<std::string>{"R", "G", "B"};
  for (std::size_t c = 0; c < image.name.size(); ++c)
    image.plane.emplace_back(image.width, image.height);
  if (!begin_rows(in, *colors)) return problem_of(path, in);
  in.row.resize(static_cast<std::size_t>(in.jpeg.output_width) *
                static_cast<std::size_t>(in.jpeg.output_components));
  const std::array<float, 256> values = code_values(options.meaning);
  for (int y = 0; y < image.height; ++y) {
    if (!read_row(in)) return problem_of(path, in);
    take_row(in, y, values, image);
  }
  if (!read_end(in)) return problem_of(path, in);
  return image;
}

}  // namespace pentimento::image

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "formats/image/decode.h"

namespace pentimento::image {

namespace {

constexpr std::string_view kFormatLine = "FORMAT=32-bit_rle_rgbe";
constexpr std::size_t kMostHeaderBytes = 1 << 16;
/// Rows of other widths are never runs.
constexpr int kLeastRunWidth = 8, kMostRunWidth = 0x7FFF;
constexpr std::size_t kChannels = 4;  // red, green, blue, the exponent that they share

using Codes = std::array<std::uint8_t, kChannels>;

struct CloseHdr {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

struct HdrSize {
  std::int64_t width = 0, height = 0;
};

/// A Radiance picture: lines of text, an empty one, the line of the size, and rows from the top.
/// A row is its pixels, or runs of each channel. All functions: empty or false says that something
/// is wrong, and problem() what.
class HdrReading {
 public:
  HdrReading(const std::string& path, std::FILE* file) : path_(path), file_(file) {}

  const Error& problem() const { return problem_; }

  std::optional<HdrSize> read_header() {
    bool known = false;
    while (true) {
      const std::optional<std::string> line = read_line();
      if (!line) return std::nullopt;
      if (line->empty()) break;
      known = known || *line == kFormatLine;
    }
    if (!known) return wrong_header(fmt::format("has no line {}", kFormatLine));
    const std::optional<std::string> line = read_line();
    if (!line) return std::nullopt;
    const std::optional<HdrSize> size = size_in(*line);
    return size ? size : wrong_header("has no line of the form -Y HEIGHT +X WIDTH");
  }

  /// The next row, four codes for each pixel.
  bool read_row(int y, std::span<Codes> row) {
    const auto width = static_cast<int>(row.size());
    std::size_t read = 0;
    if (!flat_ && width >= kLeastRunWidth && width <= kMostRunWidth) {
      if (!read_codes(y, row.first(1))) return false;
      const Codes& first = row[0];
      if (first[0] == 2 && first[1] == 2 && first[2] < 128)
        return (first[2] << 8 | first[3]) == width
                   ? read_runs(y, row)
                   : wrong_row(y, fmt::format("says that it has {} pixels of {}",
                                              first[2] << 8 | first[3], width));
      flat_ = true;  // and so are all that follow
      read = 1;
    }
    return read_codes(y, row.subspan(read));
  }

 private:
  std::nullopt_t wrong_header(const std::string& what) {
    problem_ = {ErrorCode::kBadInput, path_ + ": the header " + what};
    return std::nullopt;
  }
  bool wrong_row(int y, const std::string& what) {
    problem_ = {ErrorCode::kBadInput, fmt::format("{}: row {} of pixels {}", path_, y, what)};
    return false;
  }
  bool ended_in_row(int y) {
    if (std::ferror(file_) == 0) return wrong_row(y, "is not whole");
    problem_ = {ErrorCode::kIo, path_ + ": cannot be read"};
    return false;
  }

  /// Without the line feed.
  std::optional<std::string> read_line() {
    std::string line;
    for (int c = 0; (c = std::fgetc(file_)) != '\n';) {
      if (c == EOF) return wrong_header("is not whole");
      if (++header_bytes_ > kMostHeaderBytes) return wrong_header("has no end");
      line.push_back(static_cast<char>(c));
    }
    return line;
  }

  /// Rows from the top, pixels from the left, as all programs write them.
  static std::optional<HdrSize> size_in(std::string_view line) {
    constexpr std::string_view kRows = "-Y ", kColumns = " +X ";
    HdrSize size;
    if (!line.starts_with(kRows)) return std::nullopt;
    const char* end = line.data() + line.size();
    const auto rows = std::from_chars(line.data() + kRows.size(), end, size.height);
    const std::string_view rest(rows.ptr, static_cast<std::size_t>(end - rows.ptr));
    if (rows.ec != std::errc() || !rest.starts_with(kColumns)) return std::nullopt;
    const auto columns = std::from_chars(rows.ptr + kColumns.size(), end, size.width);
    if (columns.ec != std::errc() || columns.ptr != end) return std::nullopt;
    return size;
  }

  bool read_codes(int y, std::span<Codes> out) {
    const std::size_t got = std::fread(out.data(), kChannels, out.size(), file_);
    return got == out.size() || ended_in_row(y);
  }

  bool read_runs(int y, std::span<Codes> row) {
    for (std::size_t channel = 0; channel < kChannels; ++channel) {
      for (std::size_t x = 0; x < row.size();) {
        const int head = std::fgetc(file_);
        if (head == EOF) return ended_in_row(y);
        // Up to 128: so many codes. Above: one code, 128 less times.
        const bool same = head > 128;
        const auto count = static_cast<std::size_t>(same ? head - 128 : head);
        if (count == 0 || count > row.size() - x)
          return wrong_row(y,
                           fmt::format("has a run of {} where {} are left", count, row.size() - x));
        int code = 0;
        for (std::size_t i = 0; i < count; ++i) {
          if ((i == 0 || !same) && (code = std::fgetc(file_)) == EOF) return ended_in_row(y);
          row[x++][channel] = static_cast<std::uint8_t>(code);
        }
      }
    }
    return true;
  }

  const std::string& path_;
  std::FILE* file_;
  Error problem_;
  std::size_t header_bytes_ = 0;
  bool flat_ = false;
};

/// What one step of a code stands for, by the exponent: 2^(exponent - 136), and 0 for black.
std::array<float, 256> steps_of_exponents() {
  std::array<float, 256> steps{};
  for (int e = 1; e < 256; ++e) steps[static_cast<std::size_t>(e)] = std::ldexp(1.0f, e - 136);
  return steps;
}

}  // namespace

Result<Image> decode_hdr(const std::string& path, const ImageReadOptions& options) {
  const std::unique_ptr<std::FILE, CloseHdr> file(std::fopen(path.c_str(), "rbe"));
  if (!file) return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(errno))};
  HdrReading in(path, file.get());
  const std::optional<HdrSize> size = in.read_header();
  if (!size) return in.problem();
  const Result<void> fits = check_size(path, size->width, size->height, options.limits);
  if (!fits) return fits.error();
  Image image;
  image.width = static_cast<int>(size->width);
  image.height = static_cast<int>(size->height);
  image.format = "hdr";
  image.bits = 32;
  image.stored_float = true;
  image.name = {"R", "G", "B"};
  for (std::size_t c = 0; c < image.name.size(); ++c)
    image.plane.emplace_back(image.width, image.height);
  const std::array<float, 256> steps = steps_of_exponents();
  std::vector<Codes> row(static_cast<std::size_t>(image.width));
  for (int y = 0; y < image.height; ++y) {
    if (!in.read_row(y, row)) return in.problem();
    for (std::size_t c = 0; c < image.plane.size(); ++c) {
      float* out = image.plane[c].row(y);
      for (const Codes& pixel : row) *out++ = static_cast<float>(pixel[c]) * steps[pixel[3]];
    }
  }
  return image;
}

}  // namespace pentimento::image

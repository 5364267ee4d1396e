#include "formats/image/tiff_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <span>

#include "formats/image/decode.h"

namespace pentimento::image {

namespace {

constexpr std::size_t kEntryBytes = 12;  // of a directory: tag, type, count, value
constexpr unsigned kWidthTag = 256, kHeightTag = 257;
constexpr unsigned kShortType = 3, kLongType = 4;

struct CloseTiff {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Numbers in the order of bytes that the file names.
class TiffNumbers {
 public:
  explicit TiffNumbers(bool big_endian) : big_endian_(big_endian) {}
  std::uint32_t of(std::span<const std::uint8_t> bytes) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
      value = value << 8 | bytes[big_endian_ ? i : bytes.size() - 1 - i];
    return value;
  }

 private:
  bool big_endian_;
};

template <std::size_t count>
bool read_bytes(std::FILE* file, std::array<std::uint8_t, count>& bytes) {
  return std::fread(bytes.data(), 1, count, file) == count;
}

}  // namespace

Result<void> check_tiff_header(const std::string& path, const ImageLimits& limits) {
  const auto broken = [&](const char* what) {
    return Error{ErrorCode::kBadInput, path + ": " + what};
  };
  const std::unique_ptr<std::FILE, CloseTiff> file(std::fopen(path.c_str(), "rbe"));
  if (!file) return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(errno))};
  std::array<std::uint8_t, 8> head{};
  if (!read_bytes(file.get(), head)) return broken("the header is not whole");
  const TiffNumbers number(head[0] == 'M');
  const std::span<const std::uint8_t> start(head);
  std::array<std::uint8_t, 2> count{};
  if (std::fseek(file.get(), static_cast<long>(number.of(start.subspan(4))), SEEK_SET) != 0 ||
      !read_bytes(file.get(), count))
    return broken("the first directory lies beyond the end");
  // A later entry of the same tag may be the one that counts: the largest must fit.
  std::int64_t width = 0, height = 0;
  for (std::uint32_t left = number.of(count); left > 0; --left) {
    std::array<std::uint8_t, kEntryBytes> bytes{};
    if (!read_bytes(file.get(), bytes)) return broken("the first directory is not whole");
    const std::span<const std::uint8_t> entry(bytes);
    const std::uint32_t tag = number.of(entry.first(2)), type = number.of(entry.subspan(2, 2));
    if (tag != kWidthTag && tag != kHeightTag) continue;
    if (type != kShortType && type != kLongType)
      return broken("its size is not a number of 16 or 32 bits");
    const std::int64_t side = number.of(entry.subspan(8, type == kShortType ? 2 : 4));
    std::int64_t& most = tag == kWidthTag ? width : height;
    most = std::max(most, side);
  }
  return check_size(path, width, height, limits);
}

}  // namespace pentimento::image

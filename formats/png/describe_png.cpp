#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <memory>

#include "formats/io/describe.h"
#include "formats/io/utf8.h"
#include "formats/png/chunks.h"
#include "formats/png/profile_chunk.h"

namespace pentimento {

namespace {

constexpr std::uint32_t kLongestChunk = 16u << 20;  // of those that are read here
constexpr double kInch_m = 0.0254;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::uint32_t number(const std::uint8_t* bytes) {
  return static_cast<std::uint32_t>(bytes[0]) << 24 | static_cast<std::uint32_t>(bytes[1]) << 16 |
         static_cast<std::uint32_t>(bytes[2]) << 8 | bytes[3];
}

bool read_bytes(std::FILE* file, std::uint8_t* bytes, std::size_t count) {
  return std::fread(bytes, 1, count, file) == count;
}

/// Takes everything up to the next NUL out of `text`.
std::string_view until_nul(std::string_view& text) {
  const std::string_view part = text.substr(0, text.find('\0'));
  text.remove_prefix(std::min(text.size(), part.size() + 1));
  return part;
}

/// tEXt: key, value. iTXt: key, flag, method, language, translated key, value. Compressed text is
/// left out: we write none.
void add_text(std::string_view type, std::string_view data, Provenance& to) {
  const std::string key(until_nul(data));
  if (type == "iTXt") {
    if (data.size() < 2 || data[0] != 0) return;
    data.remove_prefix(2);
    until_nul(data);
    until_nul(data);
  }
  to.emplace_back(key, std::string(data));
}

void take_chunk(std::string_view type, const png::PngBytes& data, FileDescription& out) {
  if (type == "IHDR" && data.size() == 13) {
    out.width = static_cast<int>(number(data.data()));
    out.height = static_cast<int>(number(data.data() + 4));
    out.bits = data[8];
    constexpr std::array<const char*, 7> kColours = {"grey",         "?", "RGB", "palette",
                                                     "grey + alpha", "?", "RGBA"};
    out.samples =
        fmt::format("{} {} bit", data[9] < kColours.size() ? kColours[data[9]] : "?", out.bits);
  } else if (type == "pHYs" && data.size() == 9 && data[8] == 1) {
    out.dpi = number(data.data()) * kInch_m;
  } else if (type == "sRGB") {
    out.profile = profile_title(ColorProfile::kSrgb);
  } else if (type == "iCCP") {
    out.profile = png::describe_iccp(data).title;
  } else if (type == "tEXt" || type == "iTXt") {
    add_text(type, {reinterpret_cast<const char*>(data.data()), data.size()}, out.provenance);
  }
}

/// One chunk: false at the end or where the file is broken (`problem` says which).
bool next_chunk(std::FILE* file, FileDescription& out, std::string& problem) {
  std::array<std::uint8_t, 8> head{};
  if (!read_bytes(file, head.data(), head.size())) {
    problem = "ends in the middle";
    return false;
  }
  const std::uint32_t length = number(head.data());
  const std::string type(reinterpret_cast<const char*>(head.data()) + 4, 4);
  if (type == "IDAT" || type == "IEND") return false;
  if (length > kLongestChunk) {
    problem = fmt::format("a {} chunk of {} bytes", type, length);
    return false;
  }
  png::PngBytes data(length);
  std::array<std::uint8_t, 4> crc{};
  if (!read_bytes(file, data.data(), length) || !read_bytes(file, crc.data(), crc.size())) {
    problem = "ends in the middle";
    return false;
  }
  const png::PngBytes whole = png::chunk(type, data);
  if (number(whole.data() + whole.size() - 4) != number(crc.data())) {
    problem = "damaged " + type + " chunk";
    return false;
  }
  take_chunk(type, data, out);
  return true;
}

}  // namespace

Result<FileDescription> describe_png(const std::string& path) {
  const File file(std::fopen(path.c_str(), "rbe"));
  if (!file || std::fseek(file.get(), sizeof png::kSignature, SEEK_SET) != 0)
    return Error{ErrorCode::kIo, path + ": cannot be read"};
  FileDescription out;
  out.format = "png";
  std::string problem;
  while (next_chunk(file.get(), out, problem)) {
  }
  if (problem.empty() && out.width <= 0) problem = "has no size";
  if (!problem.empty()) {
    constexpr std::size_t kMostMessageBytes = 200;
    // A chunk's type may be any four bytes.
    return Error{ErrorCode::kBadInput,
                 path + ": " + brief_line(valid_utf8(problem), kMostMessageBytes)};
  }
  return out;
}

}  // namespace pentimento

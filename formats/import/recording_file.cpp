#include "formats/import/recording_file.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <span>

#include "formats/io/read_file.h"
#include "formats/log/stream/byte_source.h"

namespace pentimento::sketch {

namespace {
constexpr std::size_t kPiece = 1 << 20;

Error damaged(const std::string& path, const Error& error) {
  return error.code == ErrorCode::kBadInput ? Error{error.code, path + ": " + error.message}
                                            : error;
}
}  // namespace

Result<std::string> read_recording(const std::string& path) {
  if (std::error_code problem; !std::filesystem::is_regular_file(path, problem))
    return read_file(path, kMostRecordingBytes);
  const Result<std::unique_ptr<log::ByteSource>> source = log::ByteSource::open(path);
  if (!source) return source.error();
  return read_recording(path, **source);
}

Result<std::string> read_recording(const std::string& path, log::ByteSource& source) {
  std::string bytes;
  while (true) {
    const std::size_t before = bytes.size();
    bytes.resize(before + kPiece);
    const Result<std::size_t> count = source.read(std::span(bytes).subspan(before));
    if (!count) return damaged(path, count.error());
    bytes.resize(before + *count);
    if (static_cast<std::int64_t>(bytes.size()) > kMostRecordingBytes)
      return Error{ErrorCode::kLimit,
                   fmt::format("{}: larger than {} bytes", path, kMostRecordingBytes)};
    if (*count == 0) break;
  }
  if (source.cut_short())
    return Error{ErrorCode::kBadInput, path + ": the packed bytes end too early"};
  return bytes;
}

}  // namespace pentimento::sketch

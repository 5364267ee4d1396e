#include "replay/log/log_files.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <utility>

#include "formats/image/read_image.h"
#include "formats/io/sha256.h"
#include "formats/log/stream/resolve.h"
#include "formats/video/video_reader.h"

namespace pentimento {

namespace {
Result<std::string> hash_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Sha256 hash;
  std::array<char, 1 << 16> bytes{};
  while (file) {
    file.read(bytes.data(), bytes.size());
    hash.update(bytes.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof()) return Error{ErrorCode::kIo, path + ": cannot be read"};
  return hash.hex();
}
}  // namespace

LogFiles::LogFiles(std::string log_path, bool allow_outside)
    : log_path_(std::move(log_path)), allow_outside_(allow_outside) {}

Result<std::string> LogFiles::use(const std::string& name) {
  if (const auto known = paths_.find(name); known != paths_.end()) return known->second;
  Result<std::filesystem::path> path = log::resolve_file(log_path_, name, allow_outside_);
  if (!path) return path.error();
  Result<std::string> hash = hash_file(path->string());
  if (!hash) return hash.error();
  paths_.emplace(name, path->string());
  hashes_.emplace(name, *hash);
  return path->string();
}

Result<std::string> LogFiles::use_picture(const std::string& name) {
  const bool known = paths_.contains(name);
  Result<std::string> path = use(name);
  if (!path || known) return path;
  if (Result<std::array<Field<float>, 3>> rgb = read_rgb(*path); !rgb) return rgb.error();
  return path;
}

Result<std::string> LogFiles::use_camera(const std::string& name) {
  const bool known = paths_.contains(name);
  Result<std::string> path = use(name);
  if (!path || known) return path;
  if (!is_video(*path)) {
    if (Result<std::array<Field<float>, 3>> rgb = read_rgb(*path); !rgb) return rgb.error();
    return path;
  }
  Result<std::unique_ptr<VideoReader>> reader = VideoReader::open(*path);
  if (!reader) return reader.error();
  if (Result<std::array<Field<float>, 3>> rgb = (*reader)->frame_at(0); !rgb) return rgb.error();
  return path;
}

}  // namespace pentimento

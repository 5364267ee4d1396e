#include "replay/log/log_files.h"

#include <array>
#include <filesystem>
#include <utility>

#include "formats/image/read_image.h"
#include "formats/io/file_sha256.h"
#include "formats/log/stream/resolve.h"
#include "formats/video/video_reader.h"

namespace pentimento {

LogFiles::LogFiles(std::string log_path, bool allow_outside)
    : log_path_(std::move(log_path)), allow_outside_(allow_outside) {}

Result<std::string> LogFiles::use(const std::string& name) {
  if (const auto known = paths_.find(name); known != paths_.end()) return known->second;
  Result<std::filesystem::path> path = log::resolve_file(log_path_, name, allow_outside_);
  if (!path) return path.error();
  Result<std::string> hash = file_sha256(path->string());
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

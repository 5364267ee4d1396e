#include "formats/io/file_place.h"

#include <sys/stat.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace pentimento {

namespace {
constexpr int kMostLinks = 40;  // one behind the other; the kernel's own limit

std::optional<FilePlace> regular(const struct stat& info) {
  if (!S_ISREG(info.st_mode)) return std::nullopt;
  return FilePlace{info.st_dev, info.st_ino, {}};
}
}  // namespace

std::string follow_links(const std::string& path) {
  std::filesystem::path at = path;
  for (int i = 0; i < kMostLinks; ++i) {
    std::error_code error;
    const std::filesystem::path target = std::filesystem::read_symlink(at, error);
    if (error) return at.string();
    at = target.is_absolute() ? target : at.parent_path() / target;
  }
  return path;
}

std::optional<FilePlace> place_of(const std::string& path) {
  struct stat info = {};
  if (::stat(path.c_str(), &info) == 0) return regular(info);
  if (errno != ENOENT) return std::nullopt;
  const std::filesystem::path end = follow_links(path);
  const std::string folder = end.parent_path().string();
  if (::stat(folder.empty() ? "." : folder.c_str(), &info) != 0) return std::nullopt;
  return FilePlace{info.st_dev, info.st_ino, end.filename().string()};
}

std::optional<FilePlace> place_of_descriptor(int descriptor) {
  struct stat info = {};
  if (::fstat(descriptor, &info) != 0) return std::nullopt;
  return regular(info);
}

}  // namespace pentimento

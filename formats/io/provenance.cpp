#include "formats/io/provenance.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "formats/io/describe.h"

namespace pentimento {

Result<FileDescription> describe_file(const std::string& path) {
  std::FILE* file = std::fopen(path.c_str(), "rbe");
  if (file == nullptr)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(errno))};
  std::array<char, 8> bytes{};
  const std::size_t n = std::fread(bytes.data(), 1, bytes.size(), file);
  const int problem = std::ferror(file) != 0 ? errno : 0;
  std::fclose(file);
  if (problem != 0)
    return Error{ErrorCode::kIo, fmt::format("{}: {}", path, std::strerror(problem))};
  const std::string_view head(bytes.data(), n);
  if (head.starts_with("\x89PNG\r\n\x1A\n")) return describe_png(path);
  if (head.starts_with("\x76\x2F\x31\x01")) return describe_exr(path);
  if (head.starts_with("\x89HDF\r\n\x1A\n")) return describe_state(path);
  return Error{ErrorCode::kBadInput, path + ": not a PNG, an EXR or a state dump"};
}

std::string provenance_value(const Provenance& provenance, const std::string& key) {
  for (const auto& [name, value] : provenance)
    if (name == key) return value;
  return "";
}

}  // namespace pentimento

#include "formats/io/provenance.h"

#include <string_view>

#include "formats/io/describe.h"
#include "formats/io/regular_file.h"

namespace pentimento {

Result<FileDescription> describe_file(const std::string& path) {
  constexpr std::size_t kLongestSignature = 8;
  const Result<std::string> bytes = first_bytes(path, kLongestSignature);
  if (!bytes) return bytes.error();
  const std::string_view head = *bytes;
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

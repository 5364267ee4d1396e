#include "formats/log/stream/log_start.h"

#include <filesystem>
#include <memory>

#include "formats/log/stream/byte_source.h"

namespace pentimento::log {

bool starts_like_a_log(const std::string& path) {
  constexpr std::size_t kEnough = 4096;  // a header names its format among its first members
  if (std::error_code problem; !std::filesystem::is_regular_file(path, problem)) return false;
  const Result<std::unique_ptr<ByteSource>> source = ByteSource::open(path);
  if (!source) return false;
  std::string head(kEnough, '\0');
  const Result<std::size_t> count = (*source)->read(head);
  if (!count) return true;
  head.resize(*count);
  return head.substr(0, head.find('\n')).find("\"pentimento-log\"") != std::string::npos;
}

}  // namespace pentimento::log

#include "formats/log/stream/log_start.h"

#include <filesystem>
#include <memory>

namespace pentimento::log {

namespace {
bool has_header(ByteSource& source) {
  constexpr std::size_t kEnough = 4096;  // a header names its format among its first members
  std::string head(kEnough, '\0');
  const Result<std::size_t> count = source.read(head);
  if (!count) return true;
  head.resize(*count);
  return head.substr(0, head.find('\n')).find("\"pentimento-log\"") != std::string::npos;
}
}  // namespace

bool starts_like_a_log(const std::string& path) {
  if (std::error_code problem; !std::filesystem::is_regular_file(path, problem)) return false;
  const Result<std::unique_ptr<ByteSource>> source = ByteSource::open(path);
  return source && has_header(**source);
}

Result<bool> starts_like_a_log(ByteSource& source) {
  const bool is_log = has_header(source);
  if (const Result<void> back = source.rewind(); !back) return back.error();
  return is_log;
}

}  // namespace pentimento::log

#include "formats/log/stream/log_start.h"

#include <cstdio>
#include <memory>

namespace pentimento::log {

bool starts_like_a_log(const std::string& path) {
  constexpr std::size_t kEnough = 4096;  // a header names its format among its first members
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  if (!file) return false;
  std::string head(kEnough, '\0');
  head.resize(std::fread(head.data(), 1, head.size(), file.get()));
  return head.starts_with("\x1f\x8b") || head.starts_with("\x28\xb5\x2f\xfd") ||
         head.substr(0, head.find('\n')).find("\"pentimento-log\"") != std::string::npos;
}

}  // namespace pentimento::log

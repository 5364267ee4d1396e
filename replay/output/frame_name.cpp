#include "replay/output/frame_name.h"

#include <fmt/format.h>

#include <cctype>

namespace pentimento {

Result<std::string> frame_name(const std::string& pattern, int frame) {
  const std::size_t at = pattern.find('%');
  std::size_t end = at == std::string::npos ? at : at + 1;
  while (end < pattern.size() && std::isdigit(static_cast<unsigned char>(pattern[end])) != 0) ++end;
  const bool fine = end < pattern.size() && pattern[end] == 'd' && end - at <= 3 &&
                    pattern.find('%', end) == std::string::npos;
  if (!fine) {
    return Error{ErrorCode::kUsage,
                 "-o " + pattern + ": numbered frames need one %d, or %04d, in the name"};
  }
  const std::string digits = pattern.substr(at + 1, end - at - 1);
  const int width = digits.empty() ? 0 : std::stoi(digits);
  const bool zeros = !digits.empty() && digits[0] == '0';
  const std::string number =
      zeros ? fmt::format("{:0{}}", frame, width) : fmt::format("{:{}}", frame, width);
  return pattern.substr(0, at) + number + pattern.substr(end + 1);
}

}  // namespace pentimento

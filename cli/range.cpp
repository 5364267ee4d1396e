#include "cli/range.h"

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace pentimento::cli {

CLI::Validator in_range(double min, double max) {
  const auto problem = [min, max](const std::string& text) -> std::string {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) {
      return fmt::format("\"{}\" is no number", text);
    }
    if (value >= min && value <= max) return {};
    return fmt::format("{} is outside {}..{}", text, min, max);
  };
  return CLI::Validator(problem, "");
}

}  // namespace pentimento::cli

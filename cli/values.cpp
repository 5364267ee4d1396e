#include "cli/values.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace pentimento::cli {

namespace {
Error expected(const std::string& option, const std::string& text, const std::string& what) {
  return {ErrorCode::kUsage, option + " " + text + ": expected " + what};
}

/// Reads a finite number off the front of `text`; false if there is none.
bool take_number(std::string_view& text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}
}  // namespace

Result<std::vector<double>> parse_numbers(const std::string& option, const std::string& text,
                                          std::size_t count) {
  std::vector<double> numbers;
  std::string_view rest = text;
  double value = 0;
  while (take_number(rest, value)) {
    numbers.push_back(value);
    if (rest.empty() || rest.front() != ',') break;
    rest.remove_prefix(1);
  }
  if (numbers.size() == count && rest.empty()) return numbers;
  const std::string what = count == 1 ? "a number" : std::to_string(count) + " numbers";
  return expected(option, text, what + (count > 1 ? " with commas between them" : ""));
}

Result<double> parse_number(const std::string& option, const std::string& text) {
  Result<std::vector<double>> numbers = parse_numbers(option, text, 1);
  if (!numbers) return numbers.error();
  return numbers->front();
}

Result<std::array<double, 3>> parse_vector(const std::string& option, const std::string& text) {
  Result<std::vector<double>> n = parse_numbers(option, text, 3);
  if (!n) return n.error();
  return std::array<double, 3>{(*n)[0], (*n)[1], (*n)[2]};
}

Result<std::int64_t> parse_bytes(const std::string& option, const std::string& text) {
  constexpr std::string_view kUnits = "KMGT";
  constexpr double kLargest = 9e18;
  std::string_view rest = text;
  double value = 0;
  if (take_number(rest, value) && value > 0) {
    const std::size_t unit = rest.size() == 1 ? kUnits.find(rest.front()) : std::string_view::npos;
    if (unit != std::string_view::npos)
      value = std::ldexp(value, 10 * (static_cast<int>(unit) + 1));
    if ((rest.empty() || unit != std::string_view::npos) && value < kLargest) {
      return static_cast<std::int64_t>(value);
    }
  }
  return expected(option, text, "bytes, as 500M or 8G");
}

Result<std::pair<std::string, std::string>> parse_model_setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  constexpr std::string_view kPrefix = "model.";
  if (equals == std::string::npos || !text.starts_with(kPrefix)) {
    return expected("--set", text, "model.NAME=VALUE");
  }
  return std::pair{text.substr(kPrefix.size(), equals - kPrefix.size()), text.substr(equals + 1)};
}

}  // namespace pentimento::cli

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

Result<double> parse_duration(const std::string& option, const std::string& text) {
  constexpr double kMostSeconds = 1e7;
  std::string_view rest = text;
  double value = 0;
  if (take_number(rest, value) && value > 0) {
    const double unit = rest.empty() || rest == "s" ? 1 : rest == "m" ? 60 : rest == "h" ? 3600 : 0;
    if (unit > 0 && value * unit <= kMostSeconds) return value * unit;
  }
  return expected(option, text, "a time, as 90s, 10m or 2h");
}

Result<std::pair<int, int>> parse_share(const std::string& option, const std::string& text) {
  constexpr int kMostShares = 1 << 20;
  int share = 0, count = 0;
  const char* const end = text.data() + text.size();
  const auto [slash, problem] = std::from_chars(text.data(), end, share);
  if (problem == std::errc{} && slash != end && *slash == '/') {
    const auto [rest, problem_too] = std::from_chars(slash + 1, end, count);
    if (problem_too == std::errc{} && rest == end && share >= 1 && share <= count &&
        count <= kMostShares)
      return std::pair(share, count);
  }
  return expected(option, text, "I/N, as 2/3, with I from 1 to N");
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

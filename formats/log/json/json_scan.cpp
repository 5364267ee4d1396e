#include "formats/log/json/json_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace pentimento::log {

namespace {

/// The index past the string that opens at `begin`, or the line's size.
std::size_t string_end(std::string_view line, std::size_t begin) {
  for (std::size_t i = begin + 1; i < line.size(); ++i) {
    if (line[i] == '\\') {
      ++i;
    } else if (line[i] == '"') {
      return i + 1;
    }
  }
  return line.size();
}

bool is_number_start(char c) {
  return c == '-' || (c >= '0' && c <= '9');
}

bool has_nonzero_digit(std::string_view number) {
  return number.substr(0, number.find_first_of("eE")).find_first_of("123456789") !=
         std::string_view::npos;
}

bool fits(std::string_view number) {
  if (number.find_first_of(".eE") == std::string_view::npos) return number.size() < 19;
  double value = 0;
  const auto error = std::from_chars(number.data(), number.data() + number.size(), value).ec;
  if (error == std::errc::result_out_of_range) return false;
  return error != std::errc() || value != 0 || !has_nonzero_digit(number);
}

}  // namespace

bool ends_inside_json(std::string_view line) {
  int depth = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '"') {
      const std::size_t end = string_end(line, i);
      if (end == line.size() && (end == i + 1 || line[end - 1] != '"')) return true;
      i = end - 1;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return depth > 0;
}

std::string unfit_number(std::string_view line) {
  constexpr std::size_t kMaxShown = 40;
  std::string_view key;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      const std::size_t end = string_end(line, i);
      key = line.substr(i + 1, end - i - 2);
      i = end - 1;
    } else if (is_number_start(line[i])) {
      const std::size_t end = std::min(line.find_first_not_of("+-.0123456789eE", i), line.size());
      const std::string_view number = line.substr(i, end - i);
      if (!fits(number)) {
        return fmt::format("{} {}{} does not fit a double-precision number", key,
                           number.substr(0, kMaxShown), number.size() > kMaxShown ? "..." : "");
      }
      i = end - 1;
    }
  }
  return {};
}

}  // namespace pentimento::log

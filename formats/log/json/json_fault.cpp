#include "formats/log/json/json_fault.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace pentimento::log {

namespace {
using nlohmann::json;

/// Hears of the first fault and of nothing else.
class FaultListener : public nlohmann::json_sax<json> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(json::number_integer_t) override { return true; }
  bool number_unsigned(json::number_unsigned_t) override { return true; }
  bool number_float(json::number_float_t, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(std::string&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t position, const std::string&,
                   const json::exception& error) override {
    position_ = position;
    said_ = error.what();
    return false;
  }
  /// Index of the last byte that was read.
  std::size_t at() const { return position_ == 0 ? 0 : position_ - 1; }
  /// The parser's own words, without the place and without what it had read.
  std::string words() const {
    const std::size_t dash = said_.rfind(" - ");
    std::string words = dash == std::string::npos ? said_ : said_.substr(dash + 3);
    return words.substr(0, words.find("; last read"));
  }

 private:
  std::size_t position_ = 0;
  std::string said_;
};

/// Characters up to the byte `at`, which is counted too.
std::size_t column_of(std::string_view line, std::size_t at) {
  const std::string_view before = line.substr(0, at + 1);
  return static_cast<std::size_t>(std::count_if(before.begin(), before.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  }));
}

/// The last byte before `at` that is no space; 0 if there is none.
char byte_before(std::string_view line, std::size_t at) {
  const std::size_t found = line.substr(0, at).find_last_not_of(" \t");
  return found == std::string_view::npos ? '\0' : line[found];
}

/// What people write who think of another notation than JSON; empty for other faults.
std::string habit_at(std::string_view line, std::size_t at) {
  const char before = byte_before(line, at);
  const std::string_view rest = line.substr(std::min(at, line.size()));
  for (const std::string_view name : {"NaN", "nan", "Infinity", "inf"})
    if (rest.starts_with(name)) return fmt::format("{} is not a number of JSON", name);
  if (rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with("#"))
    return "JSON has no comments";
  if (rest.starts_with("'")) return "JSON has double quotes, not single ones";
  if (before == ',' && (rest.starts_with("}") || rest.starts_with("]")))
    return fmt::format("a comma before {}", rest.front());
  return {};
}
}  // namespace

std::string json_fault(std::string_view line) {
  FaultListener listener;
  if (json::sax_parse(line, &listener)) return {};
  // The parser has read a little into what it did not understand: "-I" of -Infinity.
  const std::size_t at = listener.at();
  const std::string habit = habit_at(line, at);
  return fmt::format("column {}: {}", column_of(line, at),
                     habit.empty() ? listener.words() : habit);
}

}  // namespace pentimento::log

#pragma once
// Builds the text of one JSON object, member by member.

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/log/tables/events.h"

namespace pentimento::log {

class JsonObject {
 public:
  JsonObject& text(std::string_view key, std::string_view value);
  JsonObject& number(std::string_view key, double value);
  JsonObject& number(std::string_view key, const std::optional<double>& value);
  JsonObject& flag(std::string_view key, bool value);
  JsonObject& numbers(std::string_view key, std::span<const double> values);
  /// "#rrggbb" where that is exact, else three numbers.
  JsonObject& color(std::string_view key, const std::optional<Rgb>& value);
  /// `json` as it is.
  JsonObject& raw(std::string_view key, std::string_view json);
  /// `members` as they are: "x-a":1,"x-b":2; nothing if empty.
  JsonObject& members(std::string_view members);

  /// The object; nothing may follow.
  std::string close();

 private:
  void key(std::string_view key);
  std::string json_ = "{";
};

/// [a,b,c] of JSON texts.
std::string json_array(const std::vector<std::string>& elements);
std::string json_numbers(std::span<const double> values);

}  // namespace pentimento::log

#pragma once
// JSON text for reports, member by member in the order given. Numbers in their shortest form,
// whatever the locale; a number that is not finite becomes null.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace pentimento {

class ReportObject {
 public:
  ReportObject& add(std::string_view key, std::string_view value);
  ReportObject& add(std::string_view key, const char* value);
  ReportObject& add(std::string_view key, double value);
  ReportObject& add(std::string_view key, std::int64_t value);
  ReportObject& add(std::string_view key, int value);
  ReportObject& add(std::string_view key, bool value);
  /// `json` is JSON text.
  ReportObject& add_json(std::string_view key, std::string_view json);

  std::string text() const { return "{" + members_ + "}"; }

 private:
  void start(std::string_view key);
  std::string members_;
};

/// "[a,b]" of JSON texts.
std::string json_array(const std::vector<std::string>& items);
/// A string as JSON text.
std::string json_string(std::string_view text);

}  // namespace pentimento

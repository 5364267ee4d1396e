#pragma once
// Parses one line of JSON into a flat list of values. It checks UTF-8, syntax, depth, duplicate
// keys, and that numbers fit a double. Buffers are reused from line to line. It does not depend on
// logs.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pentimento::log {

enum class JsonKind : std::uint8_t { kObject, kArray, kString, kNumber, kBool, kNull };

/// A value. The content of a container follows it; `end` is the index past that content.
struct JsonNode {
  std::string_view key;   // empty outside objects
  std::string_view text;  // of a string, unescaped
  double number = 0;      // of a number; of a bool 0 or 1
  int end = 0;
  int children = 0;
  JsonKind kind = JsonKind::kNull;
};

class JsonLine {
 public:
  JsonLine();
  ~JsonLine();

  /// Bytes that must be readable after the text given to parse(); what they hold does not matter.
  static constexpr std::size_t kPadding = 64;

  /// Parses one line that must hold one object. Returns what is wrong, or an empty string. The
  /// nodes hold until the next call.
  std::string parse(std::string_view line, int max_depth);

  /// nodes()[0] is the object itself.
  const std::vector<JsonNode>& nodes() const { return nodes_; }
  /// The value as compact JSON.
  std::string json_of(const JsonNode& node) const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
  std::vector<JsonNode> nodes_;
};

}  // namespace pentimento::log

#pragma once
// Takes the members of one JSON object by name, and checks kind and range, and which members are
// missing or unknown.
// The first problem is kept; after it, members have default values. Of an object with more than 64
// members only the first 64 are seen, and finish() refuses it.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "formats/log/json/json_line.h"
#include "formats/log/tables/events.h"
#include "formats/log/tables/parameter.h"
#include "formats/log/tables/range.h"

namespace pentimento::log {

class Fields {
 public:
  /// `prefix` goes before names in messages: "canvas." for members of canvas.
  Fields(const JsonLine& line, const JsonNode& object, std::string_view prefix = {});

  bool has(std::string_view name);
  std::optional<double> number(std::string_view name, const Range& range);
  std::optional<std::int64_t> whole(std::string_view name, const Range& range);
  std::optional<bool> flag(std::string_view name);
  std::optional<std::string> text(std::string_view name);
  std::optional<std::string_view> text_view(std::string_view name);  // holds as long as the line
  /// Index into `choices`.
  std::optional<int> choice(std::string_view name, std::span<const std::string_view> choices);
  std::optional<Rgb> triple(std::string_view name, const Range& range);
  /// A colour as linear light, from "#rrggbb" (sRGB) or from a linear triple 0..1.
  std::optional<Rgb> color(std::string_view name);
  std::optional<std::vector<double>> numbers(std::string_view name, const Range& range);
  /// A value of the table's kind and range.
  std::optional<double> parameter(const Parameter& parameter, std::string_view name);
  /// The members of an object, or the elements of an array.
  const JsonNode* object(std::string_view name);
  std::vector<const JsonNode*> elements(std::string_view name);
  /// `node` as three numbers; `name` is for the message. False after a problem.
  bool read_triple(const JsonNode& node, std::string_view name, const Range& range, Rgb& out);
  /// The same for two numbers, each with a range of its own.
  bool read_pair(const JsonNode& node, std::string_view name, const std::array<Range, 2>& range,
                 std::array<double, 2>& out);

  /// What `value` holds. If it holds nothing, notes that `name` is missing and returns a default.
  template <typename T>
  T required(std::string_view name, std::optional<T> value) {
    if (!value) missing(name);
    return value.value_or(T{});
  }

  /// Notes a problem unless there is one already.
  void fail(std::string problem);
  void fail_unless_empty(std::string problem) {
    if (!problem.empty()) fail(std::move(problem));
  }
  void missing(std::string_view name);
  /// Notes "name value reason" for a member that is there.
  void reject(std::string_view name, std::string_view reason);

  /// The first problem, else the first member nobody asked for, else empty.
  std::string finish();
  const std::string& problem() const { return problem_; }
  bool ok() const { return problem_.empty(); }
  /// Members named x-..., as "x-a":1,"x-b":[2]; after finish().
  const std::string& extensions() const { return extensions_; }
  std::string_view prefix() const { return prefix_; }
  const JsonLine& line() const { return line_; }

 private:
  const JsonNode* find(std::string_view name);
  const JsonNode* find_of_kind(std::string_view name, JsonKind kind, std::string_view wanted);
  bool in_range(const JsonNode& node, std::string_view name, const Range& range);
  void fail_value(std::string_view name, const JsonNode& node, std::string_view reason);
  void collect(const JsonNode& node);

  const JsonLine& line_;
  const JsonNode& object_;
  std::string_view prefix_;
  static constexpr std::size_t kMaxMembers = 64;
  std::array<const JsonNode*, kMaxMembers> member_;  // the first members_ are set
  std::array<std::string_view, kMaxMembers> asked_;  // for suggestions; the first asked_count_
  std::size_t members_ = 0, asked_count_ = 0, cursor_ = 0;
  std::uint64_t used_ = 0;  // a bit per member
  std::string problem_, extensions_;
};

/// The sRGB colour "#rrggbb" as linear light, or nothing.
std::optional<Rgb> parse_hex_color(std::string_view text);

}  // namespace pentimento::log

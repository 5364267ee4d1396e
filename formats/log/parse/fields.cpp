#include "formats/log/parse/fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/optics/srgb.h"
#include "formats/log/json/json_text.h"
#include "formats/log/json/nearest_name.h"

namespace pentimento::log {

namespace {

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::size_t as_size(int count) {
  return static_cast<std::size_t>(count);
}

}  // namespace

std::optional<Rgb> parse_hex_color(std::string_view text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  Rgb color{};
  for (std::size_t i = 0; i < 3; ++i) {
    const int high = hex_digit(text[1 + 2 * i]), low = hex_digit(text[2 + 2 * i]);
    if (high < 0 || low < 0) return std::nullopt;
    color[i] = kSrgb8ToLinear[static_cast<std::size_t>(16 * high + low)];
  }
  return color;
}

Fields::Fields(const JsonLine& line, const JsonNode& object, std::string_view prefix)
    : line_(line), object_(object), prefix_(prefix) {
  const JsonNode* const nodes = line.nodes().data();
  const std::size_t count = std::min<std::size_t>(kMaxMembers, as_size(object.children));
  for (const JsonNode* child = &object + 1; members_ < count; child = nodes + child->end) {
    member_[members_++] = child;
  }
}

/// The search goes on from the member that was found last, for most logs keep the documented order.
const JsonNode* Fields::find(std::string_view name) {
  if (asked_count_ < kMaxMembers) asked_[asked_count_++] = name;
  for (std::size_t i = 0; i < members_; ++i) {
    const std::size_t at = cursor_ + i < members_ ? cursor_ + i : cursor_ + i - members_;
    if (member_[at]->key != name) continue;
    used_ |= std::uint64_t{1} << at;
    cursor_ = at + 1 < members_ ? at + 1 : 0;
    return member_[at];
  }
  return nullptr;
}

const JsonNode* Fields::find_of_kind(std::string_view name, JsonKind kind,
                                     std::string_view wanted) {
  const JsonNode* node = find(name);
  if (node == nullptr || node->kind == kind) return node;
  fail_value(name, *node, fmt::format("is not {}", wanted));
  return nullptr;
}

bool Fields::has(std::string_view name) {
  return find(name) != nullptr;
}

bool Fields::in_range(const JsonNode& node, std::string_view name, const Range& range) {
  if (node.kind != JsonKind::kNumber) {
    fail_value(name, node, "is not a number");
    return false;
  }
  if (node.number >= range.min && node.number <= range.max) return true;
  fail_value(name, node,
             fmt::format("is outside {}..{}{}{}", range.min, range.max,
                         range.unit.empty() ? "" : " ", range.unit));
  return false;
}

std::optional<double> Fields::number(std::string_view name, const Range& range) {
  const JsonNode* node = find(name);
  if (node == nullptr || !in_range(*node, name, range)) return std::nullopt;
  return node->number;
}

std::optional<std::int64_t> Fields::whole(std::string_view name, const Range& range) {
  const JsonNode* node = find(name);
  if (node == nullptr || !in_range(*node, name, range)) return std::nullopt;
  if (node->number != std::floor(node->number)) {
    fail_value(name, *node, "is not a whole number");
    return std::nullopt;
  }
  return static_cast<std::int64_t>(node->number);
}

std::optional<bool> Fields::flag(std::string_view name) {
  const JsonNode* node = find_of_kind(name, JsonKind::kBool, "true or false");
  if (node == nullptr) return std::nullopt;
  return node->number != 0;
}

std::optional<std::string_view> Fields::text_view(std::string_view name) {
  const JsonNode* node = find_of_kind(name, JsonKind::kString, "a string");
  if (node == nullptr) return std::nullopt;
  return node->text;
}

std::optional<std::string> Fields::text(std::string_view name) {
  const std::optional<std::string_view> view = text_view(name);
  if (!view) return std::nullopt;
  return std::string(*view);
}

std::optional<int> Fields::choice(std::string_view name,
                                  std::span<const std::string_view> choices) {
  const JsonNode* node = find(name);
  if (node == nullptr) return std::nullopt;
  for (std::size_t i = 0; i < choices.size() && node->kind == JsonKind::kString; ++i) {
    if (node->text == choices[i]) return static_cast<int>(i);
  }
  fail_value(name, *node, fmt::format("is not {}", fmt::join(choices, ", ")));
  return std::nullopt;
}

bool Fields::read_triple(const JsonNode& node, std::string_view name, const Range& range,
                         Rgb& out) {
  if (node.kind != JsonKind::kArray || node.children != 3) {
    fail_value(name, node, "is not an array of three numbers");
    return false;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const JsonNode& element = *(&node + 1 + i);
    // Elements that are containers fail here, so that the next index is right.
    if (!in_range(element, fmt::format("{}[{}]", name, i), range)) return false;
    out[i] = element.number;
  }
  return true;
}

bool Fields::read_pair(const JsonNode& node, std::string_view name,
                       const std::array<Range, 2>& range, std::array<double, 2>& out) {
  if (node.kind != JsonKind::kArray || node.children != 2) {
    fail_value(name, node, "is not an array of two numbers");
    return false;
  }
  for (std::size_t i = 0; i < 2; ++i) {
    const JsonNode& element = *(&node + 1 + i);
    if (!in_range(element, fmt::format("{}[{}]", name, i), range[i])) return false;
    out[i] = element.number;
  }
  return true;
}

std::optional<Rgb> Fields::triple(std::string_view name, const Range& range) {
  const JsonNode* node = find(name);
  Rgb value{};
  if (node == nullptr || !read_triple(*node, name, range, value)) return std::nullopt;
  return value;
}

std::optional<Rgb> Fields::color(std::string_view name) {
  const JsonNode* node = find(name);
  if (node == nullptr) return std::nullopt;
  if (node->kind == JsonKind::kString) {
    const std::optional<Rgb> color = parse_hex_color(node->text);
    if (!color) fail_value(name, *node, "is not #rrggbb");
    return color;
  }
  Rgb value{};
  if (node->kind != JsonKind::kArray) {
    fail_value(name, *node, "is neither \"#rrggbb\" nor three numbers 0..1");
    return std::nullopt;
  }
  if (!read_triple(*node, name, {0, 1}, value)) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> Fields::numbers(std::string_view name, const Range& range) {
  const JsonNode* node = find_of_kind(name, JsonKind::kArray, "an array of numbers");
  if (node == nullptr) return std::nullopt;
  std::vector<double> values;
  for (int i = 0; i < node->children; ++i) {
    const JsonNode& element = *(node + 1 + i);
    if (!in_range(element, fmt::format("{}[{}]", name, i), range)) return std::nullopt;
    values.push_back(element.number);
  }
  return values;
}

std::optional<double> Fields::parameter(const Parameter& parameter, std::string_view name) {
  switch (parameter.kind) {
    case ParameterKind::kFlag:
      if (const std::optional<bool> value = flag(name)) return *value ? 1.0 : 0.0;
      return std::nullopt;
    case ParameterKind::kChoice:
      if (const std::optional<int> value = choice(name, parameter.choices)) return *value;
      return std::nullopt;
    case ParameterKind::kWhole:
      if (const auto value = whole(name, {parameter.min, parameter.max, parameter.unit})) {
        return static_cast<double>(*value);
      }
      return std::nullopt;
    case ParameterKind::kNumber:
      break;
  }
  return number(name, {parameter.min, parameter.max, parameter.unit});
}

const JsonNode* Fields::object(std::string_view name) {
  return find_of_kind(name, JsonKind::kObject, "an object");
}

std::vector<const JsonNode*> Fields::elements(std::string_view name) {
  std::vector<const JsonNode*> list;
  const JsonNode* array = find_of_kind(name, JsonKind::kArray, "an array");
  if (array == nullptr) return list;
  const JsonNode* const nodes = line_.nodes().data();
  for (const JsonNode* child = array + 1; child < nodes + array->end; child = nodes + child->end) {
    list.push_back(child);
  }
  return list;
}

void Fields::fail(std::string problem) {
  if (problem_.empty()) problem_ = std::move(problem);
}

void Fields::missing(std::string_view name) {
  fail(fmt::format("{}{} is missing", prefix_, name));
}

void Fields::reject(std::string_view name, std::string_view reason) {
  if (const JsonNode* node = find(name)) fail_value(name, *node, reason);
}

void Fields::fail_value(std::string_view name, const JsonNode& node, std::string_view reason) {
  constexpr std::size_t kMaxShown = 60;
  if (!ok()) return;
  std::string value = line_.json_of(node);
  if (value.size() > kMaxShown) value = "value";
  fail(fmt::format("{}{} {} {}", prefix_, name, value, reason));
}

void Fields::collect(const JsonNode& node) {
  if (!extensions_.empty()) extensions_ += ',';
  append_json_string(extensions_, node.key);
  extensions_ += ':';
  extensions_ += line_.json_of(node);
}

std::string Fields::finish() {
  if (as_size(object_.children) > kMaxMembers) {
    fail(fmt::format("{}{} fields in one object, where {} are known", prefix_, object_.children,
                     asked_count_));
  }
  for (std::size_t i = 0; i < members_ && ok(); ++i) {
    if ((used_ >> i & 1) != 0) continue;
    const std::string_view key = member_[i]->key;
    if (key.starts_with("x-")) {
      collect(*member_[i]);
    } else {
      fail(fmt::format("unknown field \"{}{}\"{}", prefix_, key,
                       did_you_mean(key, std::span(asked_).first(asked_count_))));
    }
  }
  return problem_;
}

}  // namespace pentimento::log

#include "formats/log/json/json_line.h"

#include <fmt/format.h>
#include <simdjson.h>

#include <algorithm>

#include "core/base/check.h"
#include "formats/log/json/json_fault.h"
#include "formats/log/json/json_scan.h"
#include "formats/log/json/json_text.h"

namespace pentimento::log {

namespace {

namespace dom = simdjson::dom;

/// Objects up to this many members are searched for duplicates pair by pair.
constexpr int kFewMembers = 24;

/// Whether an exponent or great length could have made a number vanish into 0.
bool may_underflow(std::string_view line) {
  return line.size() > 300 || line.find("e-") != std::string_view::npos ||
         line.find("E-") != std::string_view::npos;
}

/// The value of an element whose type is known.
template <typename T>
T get(dom::element element) {
  T value{};
  PENTIMENTO_CHECK(element.get(value) == simdjson::SUCCESS);
  return value;
}

/// Fills the flat list from a parsed document.
struct Builder {
  std::vector<JsonNode>& nodes;
  bool nul = false;   // some string holds a NUL
  bool zero = false;  // some number written as a real is 0
  std::string_view duplicate = {};
  bool has_duplicate = false;

  void add(dom::element value, std::string_view key) {
    const std::size_t self = nodes.size();
    nodes.push_back({key, {}, 0, 0, 0, JsonKind::kNull});
    nul |= key.find('\0') != std::string_view::npos;
    switch (value.type()) {
      case dom::element_type::OBJECT:
        add_object(get<dom::object>(value), self);
        break;
      case dom::element_type::ARRAY:
        add_array(get<dom::array>(value), self);
        break;
      default:
        set_scalar(nodes[self], value);
    }
    nodes[self].end = static_cast<int>(nodes.size());
  }

  void add_array(dom::array array, std::size_t self) {
    nodes[self].kind = JsonKind::kArray;
    for (const dom::element element : array) {
      add(element, {});
      ++nodes[self].children;
    }
  }

  void add_object(dom::object object, std::size_t self) {
    nodes[self].kind = JsonKind::kObject;
    for (const dom::key_value_pair member : object) {
      add(member.value, member.key);
      ++nodes[self].children;
    }
    find_duplicate(self);
  }

  void set_scalar(JsonNode& node, dom::element value) {
    switch (value.type()) {
      case dom::element_type::STRING:
        node.kind = JsonKind::kString;
        node.text = get<std::string_view>(value);
        nul |= node.text.find('\0') != std::string_view::npos;
        break;
      case dom::element_type::BOOL:
        node.kind = JsonKind::kBool;
        node.number = get<bool>(value) ? 1 : 0;
        break;
      case dom::element_type::NULL_VALUE:
        break;
      default:
        node.kind = JsonKind::kNumber;
        node.number = get<double>(value);
        zero |= node.number == 0 && value.is_double();
    }
  }

  void find_duplicate(std::size_t self) {
    const auto next = [&](std::size_t i) { return static_cast<std::size_t>(nodes[i].end); };
    const std::size_t end = nodes.size();
    if (nodes[self].children <= kFewMembers) {
      for (std::size_t i = self + 1; i < end; i = next(i)) {
        for (std::size_t j = next(i); j < end; j = next(j)) {
          if (nodes[i].key == nodes[j].key) note_duplicate(nodes[i].key);
        }
      }
      return;
    }
    std::vector<std::string_view> keys;
    for (std::size_t i = self + 1; i < end; i = next(i)) keys.push_back(nodes[i].key);
    std::sort(keys.begin(), keys.end());
    const auto twin = std::adjacent_find(keys.begin(), keys.end());
    if (twin != keys.end()) note_duplicate(*twin);
  }

  void note_duplicate(std::string_view key) {
    duplicate = key;
    has_duplicate = true;
  }

  std::string problem(std::string_view line) const {
    if (has_duplicate) return fmt::format("duplicate key \"{}\"", duplicate);
    if (nul) return "a string holds a NUL character";
    if (zero && may_underflow(line)) return unfit_number(line);
    return {};
  }
};

std::string parse_problem(simdjson::error_code error, std::string_view line, int max_depth) {
  switch (error) {
    case simdjson::UTF8_ERROR:
      return "not valid UTF-8";
    case simdjson::UNESCAPED_CHARS:
      return "not valid JSON: a control character inside a string";
    case simdjson::DEPTH_ERROR:
      return fmt::format("nested deeper than {} levels", max_depth);
    case simdjson::MEMALLOC:
      return "the line does not fit into memory";
    default:
      break;
  }
  if (ends_inside_json(line)) return "not valid JSON: it does not end";
  std::string number = unfit_number(line);
  if (!number.empty()) return number;
  const std::string fault = json_fault(line);
  return fault.empty() ? "not valid JSON" : "not valid JSON: " + fault;
}

}  // namespace

struct JsonLine::Parser {
  dom::parser parser;
  int max_depth = 0;
};

JsonLine::JsonLine() : parser_(std::make_unique<Parser>()) {
  static_assert(kPadding >= simdjson::SIMDJSON_PADDING);
}
JsonLine::~JsonLine() = default;

std::string JsonLine::parse(std::string_view line, int max_depth) {
  nodes_.clear();
  dom::parser& parser = parser_->parser;
  if (parser.capacity() < line.size() || parser_->max_depth != max_depth) {
    const std::size_t capacity = std::max<std::size_t>(2 * line.size(), 4096);
    // The document's root takes one level of the parser's count.
    if (parser.allocate(capacity, static_cast<std::size_t>(max_depth) + 1)) {
      return "the line does not fit into memory";
    }
    parser_->max_depth = max_depth;
  }
  dom::element root;
  const auto error = parser.parse(line.data(), line.size(), false).get(root);
  if (error) return parse_problem(error, line, max_depth);
  if (!root.is_object()) return "not a JSON object";
  Builder builder{nodes_};
  builder.add(root, {});
  return builder.problem(line);
}

std::string JsonLine::json_of(const JsonNode& node) const {
  std::string json;
  switch (node.kind) {
    case JsonKind::kNull:
      return "null";
    case JsonKind::kBool:
      return node.number != 0 ? "true" : "false";
    case JsonKind::kNumber:
      append_json_number(json, node.number);
      return json;
    case JsonKind::kString:
      append_json_string(json, node.text);
      return json;
    case JsonKind::kObject:
    case JsonKind::kArray:
      break;
  }
  const bool object = node.kind == JsonKind::kObject;
  json += object ? '{' : '[';
  for (const JsonNode* child = &node + 1; child < nodes_.data() + node.end;
       child = nodes_.data() + child->end) {
    if (json.size() > 1) json += ',';
    if (object) {
      append_json_string(json, child->key);
      json += ':';
    }
    json += json_of(*child);
  }
  json += object ? '}' : ']';
  return json;
}

}  // namespace pentimento::log

#include "formats/log/write/json_object.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/optics/srgb.h"
#include "formats/log/json/json_text.h"

namespace pentimento::log {

namespace {

/// "#rrggbb" if each component is exactly the linear light of an 8-bit value.
std::optional<std::string> exact_hex(const Rgb& color) {
  std::string hex = "#";
  for (const double component : color) {
    const auto found = std::lower_bound(kSrgb8ToLinear.begin(), kSrgb8ToLinear.end(), component);
    if (found == kSrgb8ToLinear.end() || *found != component) return std::nullopt;
    hex += fmt::format("{:02x}", found - kSrgb8ToLinear.begin());
  }
  return hex;
}

}  // namespace

void JsonObject::key(std::string_view key) {
  if (json_.size() > 1) json_ += ',';
  append_json_string(json_, key);
  json_ += ':';
}

JsonObject& JsonObject::text(std::string_view name, std::string_view value) {
  key(name);
  append_json_string(json_, value);
  return *this;
}

JsonObject& JsonObject::number(std::string_view name, double value) {
  key(name);
  append_json_number(json_, value);
  return *this;
}

JsonObject& JsonObject::number(std::string_view name, const std::optional<double>& value) {
  return value ? number(name, *value) : *this;
}

JsonObject& JsonObject::flag(std::string_view name, bool value) {
  return raw(name, value ? "true" : "false");
}

JsonObject& JsonObject::numbers(std::string_view name, std::span<const double> values) {
  return raw(name, json_numbers(values));
}

JsonObject& JsonObject::color(std::string_view name, const std::optional<Rgb>& value) {
  if (!value) return *this;
  const std::optional<std::string> hex = exact_hex(*value);
  return hex ? text(name, *hex) : numbers(name, *value);
}

JsonObject& JsonObject::raw(std::string_view name, std::string_view json) {
  key(name);
  json_ += json;
  return *this;
}

JsonObject& JsonObject::members(std::string_view members) {
  if (members.empty()) return *this;
  if (json_.size() > 1) json_ += ',';
  json_ += members;
  return *this;
}

std::string JsonObject::close() {
  json_ += '}';
  return std::move(json_);
}

std::string json_array(const std::vector<std::string>& elements) {
  return fmt::format("[{}]", fmt::join(elements, ","));
}

std::string json_numbers(std::span<const double> values) {
  std::string json = "[";
  for (const double value : values) {
    if (json.size() > 1) json += ',';
    append_json_number(json, value);
  }
  json += ']';
  return json;
}

}  // namespace pentimento::log

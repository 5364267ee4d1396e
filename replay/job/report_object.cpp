#include "replay/job/report_object.h"

#include <cmath>

#include "formats/log/json/json_text.h"

namespace pentimento {

void ReportObject::start(std::string_view key) {
  if (!members_.empty()) members_ += ',';
  log::append_json_string(members_, key);
  members_ += ':';
}

ReportObject& ReportObject::add(std::string_view key, std::string_view value) {
  start(key);
  log::append_json_string(members_, value);
  return *this;
}

ReportObject& ReportObject::add(std::string_view key, const char* value) {
  return add(key, std::string_view(value));
}

ReportObject& ReportObject::add(std::string_view key, double value) {
  start(key);
  if (std::isfinite(value)) {
    log::append_json_number(members_, value);
  } else {
    members_ += "null";
  }
  return *this;
}

ReportObject& ReportObject::add(std::string_view key, std::int64_t value) {
  return add_json(key, std::to_string(value));
}

ReportObject& ReportObject::add(std::string_view key, int value) {
  return add(key, std::int64_t{value});
}

ReportObject& ReportObject::add(std::string_view key, bool value) {
  return add_json(key, value ? "true" : "false");
}

ReportObject& ReportObject::add_json(std::string_view key, std::string_view json) {
  start(key);
  members_ += json;
  return *this;
}

std::string json_array(const std::vector<std::string>& items) {
  std::string text = "[";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += ',';
    text += items[i];
  }
  return text + "]";
}

std::string json_string(std::string_view text) {
  std::string json;
  log::append_json_string(json, text);
  return json;
}

}  // namespace pentimento

// docs/action-log.md and its JSON Schema say of each parameter what the code does.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "formats/log/tables/model_fields.h"
#include "formats/log/tables/slider_fields.h"
#include "tests/formats/log/log_text.h"

namespace pentimento::log {
namespace {

std::string read_doc(const std::string& name) {
  std::ifstream file(std::string(PENTIMENTO_SOURCE_DIR) + "/docs/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string range_text(const Parameter& parameter) {
  if (parameter.kind == ParameterKind::kFlag) return "true or false";
  if (parameter.kind == ParameterKind::kChoice) {
    return fmt::format("`{}`", fmt::join(parameter.choices, "` or `"));
  }
  return fmt::format("{}..{}", parameter.min, parameter.max);
}

/// The row of a table up to the reason.
std::string row_start(const Parameter& parameter, std::string json) {
  std::replace(json.begin(), json.end(), '"', '`');
  return fmt::format("| `{}` | {} | {} | {} | {} |", parameter.name,
                     parameter.unit.empty() ? "-" : parameter.unit, range_text(parameter), json,
                     parameter.reason);
}

TEST(ActionLogDocs, HaveEveryModelParameterAsItIs) {
  const std::string text = read_doc("action-log.md");
  const Model model;
  for (const ModelField& field : model_fields()) {
    const std::string row = row_start(field, model_value_json(field, model)) +
                            (field.while_painting ? " yes |" : " no |");
    EXPECT_NE(text.find(row), std::string::npos) << "docs/action-log.md needs this row:\n" << row;
  }
}

TEST(ActionLogDocs, HaveEveryBrushSliderAsItIs) {
  const std::string text = read_doc("action-log.md");
  const BrushSettings brush;
  for (const SliderField& field : slider_fields()) {
    const double value = static_cast<double>(brush.*(field.member));
    const std::string row = row_start(field, value_json(field, value));
    EXPECT_NE(text.find(row), std::string::npos) << "docs/action-log.md needs this row:\n" << row;
  }
}

/// The start of the schema's entry, as it is laid out in the file.
std::string schema_start(const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::kFlag:
      return fmt::format("\"{}\": {{\"type\": \"boolean\"", parameter.name);
    case ParameterKind::kChoice:
      return fmt::format("\"{}\": {{\"enum\": [\"{}\"]", parameter.name,
                         fmt::join(parameter.choices, "\", \""));
    default:
      return fmt::format("\"{}\": {{\"type\": \"{}\", \"minimum\": {}, \"maximum\": {}",
                         parameter.name,
                         parameter.kind == ParameterKind::kWhole ? "integer" : "number",
                         parameter.min, parameter.max);
  }
}

TEST(ActionLogSchema, HasEveryParametersKindAndRange) {
  std::string text = read_doc("action-log.schema.json");
  // The layout of the file does not matter.
  std::string packed;
  for (const char c : text) {
    if (c == '\n' || (c == ' ' && (packed.empty() || packed.back() == ' ' || packed.back() == '{')))
      continue;
    packed += c;
  }
  for (const ModelField& field : model_fields()) {
    EXPECT_NE(packed.find(schema_start(field)), std::string::npos) << schema_start(field);
  }
  for (const std::string_view name : slider_names()) {
    const std::string constant = fmt::format("{{\"const\": \"{}\"}}", name);
    EXPECT_NE(packed.find(constant), std::string::npos) << constant;
  }
}

/// Code blocks of the page that are logs.
TEST(ActionLogDocs, ShowALogThatLoads) {
  const std::string text = read_doc("action-log.md");
  const std::string fence = "```json\n";
  const std::size_t begin = text.find(fence) + fence.size();
  const Outcome outcome = read_text(text.substr(begin, text.find("```", begin) - begin));
  EXPECT_TRUE(outcome.ok) << outcome.message;
  EXPECT_EQ(outcome.events.size(), 5u);
}

}  // namespace
}  // namespace pentimento::log

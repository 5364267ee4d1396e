#include "formats/log/tables/parameter.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace pentimento::log {

namespace {

std::string choice_list(const Parameter& parameter) {
  return fmt::format("{}", fmt::join(parameter.choices, " or "));
}

Error wrong_text(const Parameter& parameter, std::string_view text, std::string_view wanted) {
  return {ErrorCode::kUsage, fmt::format("{} \"{}\" is not {}", parameter.name, text, wanted)};
}

Result<double> parse_number(const Parameter& parameter, std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    return wrong_text(parameter, text, "a number");
  }
  std::string problem = value_problem(parameter, value);
  if (!problem.empty()) return Error{ErrorCode::kUsage, std::move(problem)};
  return value;
}

}  // namespace

std::string value_problem(const Parameter& parameter, double value) {
  // Compares the value as it is stored: a dump gives back 0.66 as the nearest float, which is a
  // little more.
  const float stored = static_cast<float>(value);
  if (!(stored >= static_cast<float>(parameter.min) &&
        stored <= static_cast<float>(parameter.max))) {
    return fmt::format("{} {} is outside {}..{}{}{}", parameter.name, value, parameter.min,
                       parameter.max, parameter.unit.empty() ? "" : " ", parameter.unit);
  }
  if (parameter.kind != ParameterKind::kNumber && value != std::floor(value)) {
    return fmt::format("{} {} is not a whole number", parameter.name, value);
  }
  return {};
}

Result<double> parse_value(const Parameter& parameter, std::string_view text) {
  switch (parameter.kind) {
    case ParameterKind::kFlag:
      if (text == "true" || text == "1") return 1.0;
      if (text == "false" || text == "0") return 0.0;
      return wrong_text(parameter, text, "true or false");
    case ParameterKind::kChoice:
      for (std::size_t i = 0; i < parameter.choices.size(); ++i) {
        if (text == parameter.choices[i]) return static_cast<double>(i);
      }
      return wrong_text(parameter, text, choice_list(parameter));
    case ParameterKind::kNumber:
    case ParameterKind::kWhole:
      break;
  }
  return parse_number(parameter, text);
}

std::string value_json(const Parameter& parameter, double value) {
  switch (parameter.kind) {
    case ParameterKind::kFlag:
      return value != 0 ? "true" : "false";
    case ParameterKind::kChoice:
      return fmt::format("\"{}\"", parameter.choices[static_cast<std::size_t>(value)]);
    case ParameterKind::kWhole:
      return fmt::format("{}", static_cast<int>(value));
    case ParameterKind::kNumber:
      break;
  }
  return fmt::format("{}", static_cast<float>(value));
}

}  // namespace pentimento::log

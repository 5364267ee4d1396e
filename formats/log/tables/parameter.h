#pragma once
// What a log, a command line or a dump may say about one named parameter: its unit, range, choices
// and the reason of its default. The tables are in model_fields.h and slider_fields.h. Values
// travel as doubles: a flag is 0 or 1, a choice the index into its names.

#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace pentimento::log {

enum class ParameterKind { kNumber, kWhole, kFlag, kChoice };

struct Parameter {
  std::string_view name;
  std::string_view unit;  // empty: a pure number
  ParameterKind kind = ParameterKind::kNumber;
  double min = 0, max = 1;                    // both allowed
  std::span<const std::string_view> choices;  // of kChoice only
  std::string_view reason;                    // of the default, in a few words
};

/// What is wrong with `value`, as "nu_max 7000 is outside 1e-12..1000 m^2/s"; empty if allowed.
std::string value_problem(const Parameter& parameter, double value);

/// From text as a command line has it: "1e-2", "4", "true", "paper". Errors: kUsage.
Result<double> parse_value(const Parameter& parameter, std::string_view text);

/// The JSON text of a value stored in single precision: shortest digits that read back as the
/// same float, true or false, or a quoted choice.
std::string value_json(const Parameter& parameter, double value);

}  // namespace pentimento::log

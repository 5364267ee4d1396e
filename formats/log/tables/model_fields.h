#pragma once
// The table of the model's parameters: the names under which logs, `--set model.NAME=VALUE`, dumps
// and provenance know the members of core's Model, with unit, range and the reason of the default.

#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "core/base/result.h"
#include "core/model/model.h"
#include "formats/log/tables/parameter.h"

namespace pentimento::log {

struct ModelField : Parameter {
  bool while_painting = true;  // a `slider` event may change it
  std::variant<float Model::*, int Model::*, bool Model::*, SchemeKind Model::*,
               OpticalThickness Model::*, OpticsKind Model::*, Illuminant Model::*,
               Observer Model::*>
      member;
};

/// All parameters, in the order in which they are documented and written.
std::span<const ModelField> model_fields();
/// nullptr if there is none of that name.
const ModelField* find_model_field(std::string_view name);

double get_model_value(const ModelField& field, const Model& model);
/// Sets a parameter. value_problem() must have accepted `value`.
void set_model_value(const ModelField& field, Model& model, double value);
/// As JSON, shortest digits: 0.01, true, "paper".
std::string model_value_json(const ModelField& field, const Model& model);

/// What is wrong between fields, as "gamma 0.9 is not below zeta 0.8"; empty if nothing.
std::string model_problem(const Model& model);

/// Sets a parameter from text, for `--set model.nu_max=1e-2`. `name` is without "model.". The model
/// does not change on an error. Call model_problem() after the last of several settings. Errors:
/// kUsage.
Result<void> set_model_text(Model& model, std::string_view name, std::string_view text);

}  // namespace pentimento::log

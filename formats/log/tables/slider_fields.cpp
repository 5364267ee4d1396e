#include "formats/log/tables/slider_fields.h"

#include "core/base/check.h"
#include "formats/log/tables/model_fields.h"

namespace pentimento::log {

namespace {

using enum ParameterKind;

const SliderField kSliders[] = {
    {{"medium", "of max_medium", kNumber, 0, 1, {}, "half a full brush"},
     &BrushSettings::medium_frac},
    {{"pigment", "of max_pigment", kNumber, 0, 1, {}, "covers in one pass"},
     &BrushSettings::pigment_frac},
    {{"size", "m", kNumber, 1e-5, 100, {}, "diameter; 3 % of the model canvas"},
     &BrushSettings::size_m},
    {{"pickup", "per diameter", kNumber, 0, 1, {}, "marbles without wiping clean"},
     &BrushSettings::pickup},
    {{"refill", "per 0.1 diameter", kNumber, 0, 1, {}, "5 % per stamp in the paper"},
     &BrushSettings::refill},
    {{"stiffness", "", kNumber, 0, 1, {}, "a brush of middling bristle"},
     &BrushSettings::stiffness},
    {{"layer_mixing", "per diameter", kNumber, 0, 1, {}, "layers blend within a few passes"},
     &BrushSettings::layer_mixing},
    {{"spacing", "diameters", kNumber, 1e-3, 10, {}, "wider prints a chain of tip marks"},
     &BrushSettings::spacing},
    {{"load", "of a full brush", kNumber, 0, 1, {}, "at touch-down; half: a dry brush"},
     &BrushSettings::load_frac},
};

const SliderField* find_slider_field(std::string_view name) {
  for (const SliderField& field : kSliders) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

}  // namespace

std::span<const SliderField> slider_fields() {
  return kSliders;
}

const Parameter* find_slider(std::string_view name) {
  if (const SliderField* field = find_slider_field(name)) return field;
  const ModelField* field = find_model_field(name);
  return field != nullptr && field->while_painting ? field : nullptr;
}

std::vector<std::string_view> slider_names() {
  std::vector<std::string_view> names;
  for (const SliderField& field : kSliders) names.push_back(field.name);
  for (const ModelField& field : model_fields()) {
    if (field.while_painting) names.push_back(field.name);
  }
  return names;
}

void apply_slider(std::string_view name, double value, BrushSettings& brush, Model& model) {
  if (const SliderField* field = find_slider_field(name)) {
    brush.*(field->member) = static_cast<float>(value);
    return;
  }
  const ModelField* field = find_model_field(name);
  PENTIMENTO_CHECK(field != nullptr);
  set_model_value(*field, model, value);
}

}  // namespace pentimento::log

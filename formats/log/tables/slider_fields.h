#pragma once
// What a `slider` event may name: the sliders of the brush (table here) and those parameters of the
// model that may change while painting (model_fields.h).

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/brush/brush_settings.h"
#include "core/model/model.h"
#include "formats/log/tables/parameter.h"

namespace pentimento::log {

struct SliderField : Parameter {
  float BrushSettings::*member;
};

/// The brush's sliders.
std::span<const SliderField> slider_fields();

/// The parameter that a `slider` event of this name sets, of either table; nullptr if none.
const Parameter* find_slider(std::string_view name);

/// All names that find_slider() knows.
std::vector<std::string_view> slider_names();

/// Sets the slider `name` (find_slider() knows it, and `value` passed value_problem()).
void apply_slider(std::string_view name, double value, BrushSettings& brush, Model& model);

}  // namespace pentimento::log

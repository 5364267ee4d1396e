#include "core/base/check.h"
#include "formats/log/tables/event_names.h"
#include "formats/log/tables/slider_fields.h"
#include "formats/log/write/json_object.h"
#include "formats/log/write/to_json.h"

namespace pentimento::log {

namespace {

/// Adds what is particular to each type of event.
struct Members {
  JsonObject& json;

  void operator()(const Touch& touch) const {
    json.text("phase", phase_name(touch.phase));
    if (touch.id != 0) json.raw("id", std::to_string(touch.id));
    json.number("x", touch.x_m).number("y", touch.y_m).number("pressure", touch.pressure);
    json.number("tilt_x", touch.tilt_x_deg).number("tilt_y", touch.tilt_y_deg);
    json.number("twist", touch.twist_deg).number("radius", touch.radius_m);
  }
  void operator()(const Gravity& gravity) const {
    json.number("x", gravity.x_m_s2).number("y", gravity.y_m_s2).number("z", gravity.z_m_s2);
  }
  void operator()(const Slider& slider) const {
    const Parameter* parameter = find_slider(slider.name);
    PENTIMENTO_CHECK(parameter != nullptr);
    json.text("name", slider.name);
    if (parameter->kind == ParameterKind::kNumber) {
      json.number("value", slider.value);
    } else {
      json.raw("value", value_json(*parameter, slider.value));
    }
  }
  void operator()(const Color& color) const {
    color.value ? json.color("value", color.value) : json.text("pigment", color.pigment);
    if (color.across) json.numbers("across", *color.across);
  }
  void operator()(const BrushChange& brush) const { json.text("name", brush.name); }
  void operator()(const Load& load) const { json.text("file", load.file); }
  void operator()(const Light& light) const {
    if (light.lamp != 0) json.number("lamp", light.lamp);
    if (light.direction) json.numbers("direction", *light.direction);
    if (light.position_m) json.numbers("position", *light.position_m);
    json.number("intensity", light.intensity).color("color", light.color);
    if (light.follow_gravity) json.text("follow", "gravity");
  }
  void operator()(const Environment& environment) const {
    if (!environment.sh) {
      json.text("file", environment.file);
      if (environment.soft) json.flag("soft", true);
      return;
    }
    std::vector<std::string> triples;
    for (const auto& triple : *environment.sh) triples.push_back(json_numbers(triple));
    json.raw("sh", json_array(triples));
  }
  void operator()(const Camera& camera) const {
    json.text("file", camera.file).number("start", camera.start_s);
    json.number("fov", camera.fov_deg).flag("mirror", camera.mirror);
  }
  void operator()(const Mark& mark) const { json.text("name", mark.name); }
  template <typename T>
  void operator()(const T&) const {}
};

}  // namespace

std::string event_json(const Event& event) {
  if (const auto* extension = std::get_if<Extension>(&event.action)) return extension->json;
  JsonObject json;
  json.number("t", static_cast<double>(event.time_us) / 1e6);
  json.text("type", type_name(event.action));
  std::visit(Members{json}, event.action);
  json.members(event.extensions);
  return json.close();
}

}  // namespace pentimento::log

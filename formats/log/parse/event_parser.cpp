#include "formats/log/parse/event_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/log/json/nearest_name.h"
#include "formats/log/parse/fields.h"
#include "formats/log/tables/ranges.h"
#include "formats/log/tables/slider_fields.h"

namespace pentimento::log {

namespace {

using Choices = std::array<std::string_view, 4>;
constexpr Choices kPhases = {"down", "move", "up", "cancel"};
constexpr std::array<std::string_view, 1> kFollow = {"gravity"};

Action parse_touch(Fields& fields) {
  Touch touch;
  touch.phase = static_cast<TouchPhase>(fields.required("phase", fields.choice("phase", kPhases)));
  touch.id = fields.whole("id", kIdRange).value_or(0);
  touch.x_m = fields.required("x", fields.number("x", kPositionRange));
  touch.y_m = fields.required("y", fields.number("y", kPositionRange));
  touch.pressure = fields.number("pressure", kUnitRange);
  touch.tilt_x_deg = fields.number("tilt_x", kTiltRange);
  touch.tilt_y_deg = fields.number("tilt_y", kTiltRange);
  touch.twist_deg = fields.number("twist", kTwistRange);
  touch.radius_m = fields.number("radius", kRadiusRange);
  return touch;
}

Action parse_gravity(Fields& fields) {
  Gravity gravity;
  gravity.x_m_s2 = fields.required("x", fields.number("x", kAccelerationRange));
  gravity.y_m_s2 = fields.required("y", fields.number("y", kAccelerationRange));
  gravity.z_m_s2 = fields.required("z", fields.number("z", kAccelerationRange));
  return gravity;
}

Action parse_slider(Fields& fields) {
  Slider slider;
  slider.name = fields.required("name", fields.text("name"));
  if (!fields.ok()) return slider;
  const Parameter* parameter = find_slider(slider.name);
  if (parameter == nullptr) {
    fields.reject("name", "is not a slider" + did_you_mean(slider.name, slider_names()));
    return slider;
  }
  slider.value = fields.required("value", fields.parameter(*parameter, "value"));
  return slider;
}

Action parse_color(Fields& fields) {
  Color color;
  const std::optional<std::string> pigment = fields.text("pigment");
  color.value = fields.color("value");
  color.pigment = pigment.value_or("");
  if (pigment.has_value() == color.value.has_value()) {
    fields.fail("color needs either pigment or value");
  }
  if (const std::optional<std::vector<double>> across = fields.numbers("across", kUnitRange)) {
    if (across->size() != 2) {
      fields.fail(fmt::format("across has {} numbers, not 2", across->size()));
    } else if (!((*across)[0] < (*across)[1])) {
      fields.fail(fmt::format("across {} is not below {}", (*across)[0], (*across)[1]));
    } else {
      color.across = {(*across)[0], (*across)[1]};
    }
  }
  return color;
}

Action parse_brush(Fields& fields) {
  return BrushChange{fields.required("name", fields.text("name"))};
}

Action parse_load(Fields& fields) {
  return Load{fields.required("file", fields.text("file"))};
}

Action parse_light(Fields& fields) {
  Light light;
  light.lamp = static_cast<int>(fields.whole("lamp", kLampRange).value_or(0));
  light.direction = fields.triple("direction", kDirectionRange);
  light.position_m = fields.triple("position", kPositionRange);
  light.intensity = fields.number("intensity", kIntensityRange);
  light.color = fields.color("color");
  light.follow_gravity = fields.choice("follow", kFollow).has_value();
  if (light.direction && *light.direction == Rgb{}) fields.reject("direction", "has no length");
  if (light.position_m && *light.position_m == Rgb{}) {
    fields.reject("position", "is the canvas's centre");
  }
  if (light.direction && light.follow_gravity) fields.fail("light has both direction and follow");
  if (light.direction && light.position_m) fields.fail("light has both direction and position");
  if (!light.direction && !light.position_m && !light.intensity && !light.color &&
      !light.follow_gravity) {
    fields.fail("light needs direction, position, intensity, color or follow");
  }
  return light;
}

/// Nine RGB triples.
std::optional<std::array<Rgb, 9>> parse_sh(Fields& fields) {
  if (!fields.has("sh")) return std::nullopt;
  std::array<Rgb, 9> sh{};
  const std::vector<const JsonNode*> rows = fields.elements("sh");
  if (rows.size() != sh.size()) fields.fail("sh needs 9 triples of red, green and blue");
  for (std::size_t i = 0; i < sh.size() && fields.ok(); ++i) {
    fields.read_triple(*rows[i], fmt::format("sh[{}]", i), kRadianceRange, sh[i]);
  }
  return sh;
}

Action parse_environment(Fields& fields) {
  Environment environment;
  const std::optional<std::string> file = fields.text("file");
  environment.sh = parse_sh(fields);
  environment.file = file.value_or("");
  const std::optional<bool> soft = fields.flag("soft");
  environment.soft = soft.value_or(false);
  if (file.has_value() == environment.sh.has_value()) {
    fields.fail("environment needs either file or sh");
  }
  if (soft && environment.sh) fields.fail("environment has both sh and soft");
  return environment;
}

Action parse_camera(Fields& fields) {
  Camera camera;
  camera.file = fields.required("file", fields.text("file"));
  camera.start_s = fields.number("start", kCameraStartRange).value_or(camera.start_s);
  camera.fov_deg = fields.number("fov", kFovRange).value_or(camera.fov_deg);
  camera.mirror = fields.flag("mirror").value_or(camera.mirror);
  return camera;
}

Action parse_mark(Fields& fields) {
  Mark mark{fields.required("name", fields.text("name"))};
  if (fields.ok() && mark.name.empty()) fields.reject("name", "is empty");
  return mark;
}

template <typename T>
Action parse_bare(Fields&) {
  return T{};
}

struct EventType {
  std::string_view name;
  Action (*parse)(Fields&);
};

constexpr EventType kTypes[] = {
    {"touch", parse_touch},       {"gravity", parse_gravity}, {"slider", parse_slider},
    {"color", parse_color},       {"brush", parse_brush},     {"dry", parse_bare<Dry>},
    {"clear", parse_bare<Clear>}, {"load", parse_load},       {"undo", parse_bare<Undo>},
    {"redo", parse_bare<Redo>},   {"light", parse_light},     {"environment", parse_environment},
    {"camera", parse_camera},     {"step", parse_bare<Step>}, {"mark", parse_mark},
};

std::string unknown_type(std::string_view type) {
  std::array<std::string_view, std::size(kTypes)> names;
  std::transform(std::begin(kTypes), std::end(kTypes), names.begin(),
                 [](const EventType& known) { return known.name; });
  return fmt::format("unknown type \"{}\"{}", type, did_you_mean(type, names));
}

}  // namespace

std::string parse_event(const JsonLine& json, std::string_view text, Event& event) {
  Fields fields(json, json.nodes()[0]);
  event.extensions.clear();
  const std::optional<std::string_view> named = fields.text_view("type");
  if (named == "header") return "a second header";  // it has no time
  const double time_s = fields.required("t", fields.number("t", kTimeRange));
  const std::string_view type = fields.required("type", named);
  if (!fields.ok()) return fields.finish();
  event.time_us = std::llround(time_s * 1e6);
  if (type.starts_with("x-")) {
    event.action = Extension{std::string(type), std::string(text)};
    return {};
  }
  for (const EventType& known : kTypes) {
    if (known.name != type) continue;
    event.action = known.parse(fields);
    std::string problem = fields.finish();
    event.extensions = fields.extensions();
    return problem;
  }
  return unknown_type(type);
}

}  // namespace pentimento::log

#include "formats/log/edit/hand_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "formats/log/tables/slider_fields.h"

namespace pentimento::log {

namespace {
/// Of a log without a palette of its own.
constexpr const char* kFirstPigment = "Ivory Black";

/// The shortest decimal number that is this float: a log says 0.03.
double as_written(float value) {
  return std::stod(fmt::format("{}", value));
}

bool same(const Color& a, const Color& b) {
  return a.pigment == b.pigment && a.value == b.value && a.across == b.across;
}
}  // namespace

HandSettings::HandSettings(const Header& header) {
  const BrushSettings defaults;
  for (const SliderField& field : slider_fields())
    sliders_.emplace(field.name, as_written(defaults.*field.member));
  Color first;
  first.pigment = header.palette.empty() ? kFirstPigment : header.palette.front().name;
  colors_ = {first};
}

bool HandSettings::take(const Event& event) {
  if (const auto* brush = std::get_if<BrushChange>(&event.action)) {
    brush_ = brush->name;
    return true;
  }
  if (const auto* slider = std::get_if<Slider>(&event.action)) {
    const auto own = sliders_.find(slider->name);
    if (own == sliders_.end()) return false;  // of the model: it holds for all
    own->second = slider->value;
    return true;
  }
  if (const auto* color = std::get_if<Color>(&event.action)) {
    if (!color->across) colors_.clear();
    colors_.push_back(*color);
    return true;
  }
  return false;
}

std::vector<Event> HandSettings::changes_from(const HandSettings& others,
                                              std::int64_t time_us) const {
  std::vector<Event> out;
  const auto send = [&](Action action) {
    Event event;
    event.time_us = time_us;
    event.action = std::move(action);
    out.push_back(std::move(event));
  };
  if (brush_ != others.brush_) send(BrushChange{brush_});
  for (const auto& [name, value] : sliders_)
    if (others.sliders_.find(name)->second != value) send(Slider{name, value});
  if (!std::equal(colors_.begin(), colors_.end(), others.colors_.begin(), others.colors_.end(),
                  same))
    for (const Color& color : colors_) send(color);
  return out;
}

}  // namespace pentimento::log

#include "formats/log/edit/settings.h"

#include <algorithm>

namespace pentimento::log {

bool Settings::take(const Event& event) {
  const Action& action = event.action;
  if (std::holds_alternative<Gravity>(action)) return keep("gravity", event), true;
  if (const auto* slider = std::get_if<Slider>(&action))
    return keep("slider " + slider->name, event), true;
  if (const auto* color = std::get_if<Color>(&action)) {
    // A dip of part of the width leaves the rest as it is; a whole one ends all that.
    if (color->across) return keep("color across " + std::to_string(order_), event), true;
    std::erase_if(kept_, [](const auto& entry) { return entry.first.starts_with("color"); });
    return keep("color", event), true;
  }
  if (std::holds_alternative<BrushChange>(action)) return keep("brush", event), true;
  if (const auto* light = std::get_if<Light>(&action))
    // A light event changes what it names: those before it hold for the rest.
    return keep("light " + std::to_string(light->lamp) + " " + std::to_string(order_), event), true;
  if (std::holds_alternative<Environment>(action)) return keep("environment", event), true;
  if (std::holds_alternative<Camera>(action)) return keep("camera", event), true;
  return false;
}

std::vector<Event> Settings::at(std::int64_t time_us) const {
  std::vector<const Kept*> in_order;
  for (const auto& [key, kept] : kept_) in_order.push_back(&kept);
  std::sort(in_order.begin(), in_order.end(),
            [](const Kept* a, const Kept* b) { return a->order < b->order; });
  std::vector<Event> out;
  for (const Kept* kept : in_order) {
    out.push_back(kept->event);
    out.back().time_us = time_us;
  }
  return out;
}

void Settings::clear() {
  kept_.clear();
}

void Settings::keep(const std::string& key, const Event& event) {
  kept_[key] = {order_++, event};
}

}  // namespace pentimento::log

#include "formats/log/edit/pace.h"

#include <algorithm>
#include <cmath>

namespace pentimento::log {

void Speed::take(const Event& event) {
  Event out = event;
  out.time_us = std::llround(static_cast<double>(event.time_us) / factor_);
  hand_on(out);
}

void DropIdle::take(const Event& event) {
  const bool sensor =
      std::holds_alternative<Gravity>(event.action) || std::holds_alternative<Light>(event.action);
  const bool idle = down_.empty() && event.time_us - busy_us_ > longest_us_;
  if (sensor) {
    if (idle)
      sensors_.take(event);
    else
      send(event);
    return;
  }
  if (idle) cut_us_ += event.time_us - busy_us_ - longest_us_;
  busy_us_ = event.time_us;
  last_us_ = event.time_us - cut_us_;
  send_sensors();
  if (const auto* touch = std::get_if<Touch>(&event.action)) {
    if (touch->phase == TouchPhase::kDown) down_.insert(touch->id);
    if (touch->phase == TouchPhase::kUp || touch->phase == TouchPhase::kCancel)
      down_.erase(touch->id);
  }
  send(event);
}

void DropIdle::send(Event event) {
  event.time_us -= cut_us_;
  last_us_ = std::max(last_us_, event.time_us);
  event.time_us = last_us_;
  hand_on(event);
}

void DropIdle::send_sensors() {
  for (const Event& event : sensors_.at(last_us_)) hand_on(event);
  sensors_.clear();
}

void DropIdle::finish() {
  last_us_ = std::max(last_us_, busy_us_ - cut_us_ + longest_us_);
  send_sensors();
}

}  // namespace pentimento::log

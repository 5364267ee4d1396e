#include "formats/log/edit/resample.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pentimento::log {

Touch between(const Touch& a, const Touch& b, double share) {
  const auto mix = [&](double from, double to) { return from + share * (to - from); };
  const auto mix_both = [&](const std::optional<double>& from, const std::optional<double>& to) {
    return from && to ? std::optional<double>(mix(*from, *to)) : std::nullopt;
  };
  Touch out = a;
  out.phase = TouchPhase::kMove;
  out.x_m = mix(a.x_m, b.x_m);
  out.y_m = mix(a.y_m, b.y_m);
  out.pressure = mix_both(a.pressure, b.pressure);
  out.tilt_x_deg = mix_both(a.tilt_x_deg, b.tilt_x_deg);
  out.tilt_y_deg = mix_both(a.tilt_y_deg, b.tilt_y_deg);
  out.twist_deg = mix_both(a.twist_deg, b.twist_deg);
  out.radius_m = mix_both(a.radius_m, b.radius_m);
  return out;
}

std::int64_t Resample::time_of(const EvenTouch& open) const {
  return open.begin_us + std::llround(static_cast<double>(open.next) * 1e6 / rate_hz_);
}

/// A touch is known up to its last sample only: what others do after that must wait.
std::int64_t Resample::oldest_open_us() const {
  std::int64_t oldest = std::numeric_limits<std::int64_t>::max();
  for (const auto& [id, open] : open_) oldest = std::min(oldest, open.last.time_us);
  return oldest;
}

void Resample::hand_on_ready(std::int64_t before_us) {
  const auto end = ready_.upper_bound(before_us);
  for (auto it = ready_.begin(); it != end; ++it) hand_on(it->second);
  ready_.erase(ready_.begin(), end);
}

/// The even samples of a touch up to its next sample of the source.
void Resample::send_until(const Event& event) {
  const auto& touch = std::get<Touch>(event.action);
  EvenTouch& open = open_[touch.id];
  const auto& last = std::get<Touch>(open.last.action);
  for (std::int64_t t = time_of(open);
       t < event.time_us || (t == event.time_us && touch.phase == TouchPhase::kMove);
       t = time_of(open)) {
    const auto span = static_cast<double>(event.time_us - open.last.time_us);
    const double share = span > 0 ? static_cast<double>(t - open.last.time_us) / span : 1;
    Event sample = open.last;
    sample.time_us = t;
    sample.extensions.clear();
    sample.action = between(last, touch, share);
    ready_.emplace(t, sample);
    ++open.next;
  }
  open.last = event;
}

void Resample::take(const Event& event) {
  const auto* touch = std::get_if<Touch>(&event.action);
  if (touch == nullptr) {
    ready_.emplace(event.time_us, event);
  } else if (touch->phase == TouchPhase::kDown) {
    open_[touch->id] = {event, event.time_us, 1};
    ready_.emplace(event.time_us, event);
  } else {
    send_until(event);
    if (touch->phase != TouchPhase::kMove) {
      ready_.emplace(event.time_us, event);
      open_.erase(touch->id);
    }
  }
  hand_on_ready(std::min(oldest_open_us(), event.time_us) - 1);
}

void Resample::finish() {
  hand_on_ready(std::numeric_limits<std::int64_t>::max());
}

}  // namespace pentimento::log

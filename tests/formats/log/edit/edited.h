#pragma once
// Events by a few words, for the tests of edits, and what a filter makes of them.

#include <string>
#include <vector>

#include "formats/log/edit/event_filter.h"
#include "formats/log/write/to_json.h"

namespace pentimento::log {

using enum TouchPhase;

inline Event at(double time_s, Action action) {
  Event event;
  event.time_us = static_cast<std::int64_t>(time_s * 1e6 + 0.5);
  event.action = std::move(action);
  return event;
}
inline Event touch(double time_s, TouchPhase phase, double x_m = 0, std::int64_t id = 0) {
  Touch t;
  t.phase = phase;
  t.id = id;
  t.x_m = x_m;
  return at(time_s, t);
}

/// The events that `Filter(arguments...)` makes of `events`, as lines of JSON.
template <typename Filter, typename... Arguments>
std::vector<std::string> edited(const std::vector<Event>& events, Arguments... arguments) {
  std::vector<std::string> lines;
  Filter filter(arguments..., [&](const Event& event) { lines.push_back(event_json(event)); });
  for (const Event& event : events) filter.take(event);
  filter.finish();
  return lines;
}

inline std::vector<std::string> lines_of(const std::vector<Event>& events) {
  std::vector<std::string> lines;
  for (const Event& event : events) lines.push_back(event_json(event));
  return lines;
}

}  // namespace pentimento::log

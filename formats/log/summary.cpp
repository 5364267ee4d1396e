#include "formats/log/summary.h"

#include <algorithm>
#include <array>

#include "formats/log/tables/event_names.h"

namespace pentimento::log {

namespace {

/// Adds one event's content to the summary.
struct Counter {
  Summary& summary;
  int down = 0;

  void operator()(const Touch& touch) {
    summary.bounds.add(touch.x_m, touch.y_m);
    summary.has_pressure |= touch.pressure.has_value();
    summary.has_tilt |= touch.tilt_x_deg.has_value() || touch.tilt_y_deg.has_value();
    if (touch.phase == TouchPhase::kMove) return;
    if (touch.phase == TouchPhase::kDown) {
      ++summary.strokes;
      summary.most_touches = std::max(summary.most_touches, ++down);
      return;
    }
    if (touch.phase == TouchPhase::kCancel) ++summary.cancelled;
    --down;
  }
  void operator()(const Color& color) {
    if (color.value) {
      summary.colors.insert(*color.value);
    } else {
      summary.pigments.insert(color.pigment);
    }
  }
  void operator()(const Load& load) { add_file(load.file); }
  void operator()(const Environment& environment) { add_file(environment.file); }
  void operator()(const Camera& camera) { add_file(camera.file); }
  void operator()(const Step&) { summary.own_steps = true; }
  void operator()(const Mark& mark) {
    if (summary.marks.size() < Summary::kMaxNames) summary.marks.push_back(mark.name);
  }
  template <typename T>
  void operator()(const T&) {}

  void add_file(const std::string& file) {
    if (!file.empty() && summary.files.size() < Summary::kMaxNames) summary.files.insert(file);
  }
};

}  // namespace

void Bounds::add(double x_m, double y_m) {
  if (empty()) {
    *this = {x_m, y_m, x_m, y_m};
    return;
  }
  min_x_m = std::min(min_x_m, x_m);
  min_y_m = std::min(min_y_m, y_m);
  max_x_m = std::max(max_x_m, x_m);
  max_y_m = std::max(max_y_m, y_m);
}

Result<Summary> summarize(Reader& reader) {
  Summary summary;
  Counter counter{summary};
  std::array<std::int64_t, std::variant_size_v<Action>> counts{};
  for (const BrushSpec& brush : reader.header().brushes) counter.add_file(brush.texture);
  for (;;) {
    const Result<std::optional<Event>> next = reader.next();
    if (!next) return next.error();
    if (!*next) break;
    const Event& event = **next;
    ++counts[event.action.index()];
    ++summary.event_count;
    summary.duration_us = event.time_us;
    std::visit(counter, event.action);
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) summary.events[std::string(type_name(i))] = counts[i];
  }
  summary.still_down = counter.down;
  summary.sha256 = reader.sha256();
  summary.salvaged = reader.salvaged();
  return summary;
}

}  // namespace pentimento::log

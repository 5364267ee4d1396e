#include "formats/log/summary.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formats/log/tables/event_names.h"

namespace pentimento::log {

namespace {

/// Adds one event's content to the summary.
struct Counter {
  Summary& summary;
  std::int64_t& down;

  void operator()(const Touch& touch) {
    summary.bounds.add(touch.x_m, touch.y_m);
    add_pen(touch);
    if (touch.phase == TouchPhase::kMove) return;
    if (touch.phase == TouchPhase::kDown) {
      ++summary.strokes;
      summary.most_touches = std::max(summary.most_touches, static_cast<int>(++down));
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

  void add_pen(const Touch& touch) {
    const auto bin = [](auto& bins, double share) {
      const auto last = static_cast<double>(bins.size() - 1);
      ++bins[static_cast<std::size_t>(std::clamp(share * (last + 1), 0.0, last))];
    };
    if (touch.pressure) {
      summary.has_pressure = true;
      bin(summary.pressures, *touch.pressure);
    }
    if (!touch.tilt_x_deg && !touch.tilt_y_deg) return;
    summary.has_tilt = true;
    const auto slope = [](const std::optional<double>& deg) {
      return std::tan(std::min(std::abs(deg.value_or(0)), 89.9) * std::numbers::pi / 180);
    };
    const double lean = std::atan(std::hypot(slope(touch.tilt_x_deg), slope(touch.tilt_y_deg)));
    bin(summary.tilts, lean * 2 / std::numbers::pi);
  }
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

Summarizer::Summarizer(const Header& header) : counts_(std::variant_size_v<Action>) {
  Counter counter{summary_, down_};
  for (const BrushSpec& brush : header.brushes) counter.add_file(brush.texture);
}

void Summarizer::add(const Event& event) {
  ++counts_[event.action.index()];
  ++summary_.event_count;
  summary_.duration_us = event.time_us;
  std::visit(Counter{summary_, down_}, event.action);
}

Summary Summarizer::finish() const {
  Summary out = summary_;
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (counts_[i] > 0) out.events[std::string(type_name(i))] = counts_[i];
  out.still_down = static_cast<int>(down_);
  return out;
}

Result<Summary> summarize(Reader& reader) {
  Summarizer sum(reader.header());
  for (;;) {
    const Result<std::optional<Event>> next = reader.next();
    if (!next) return next.error();
    if (!*next) break;
    sum.add(**next);
  }
  Summary summary = sum.finish();
  summary.sha256 = reader.sha256();
  summary.salvaged = reader.salvaged();
  return summary;
}

}  // namespace pentimento::log

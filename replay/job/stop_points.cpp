#include "replay/job/stop_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "replay/job/step_clock.h"

namespace pentimento {

namespace {
constexpr double kMaxSeconds = 1e9;

/// The whole text as a number; nothing if it is anything else.
template <typename T>
std::optional<T> number_in(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string file_safe(std::string text) {
  for (char& c : text) {
    if (c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20) c = '_';
  }
  return text;
}

Error unknown_point(const std::string& text) {
  return {ErrorCode::kUsage, "--at " + text + ": expected seconds, step:N or mark:NAME"};
}
}  // namespace

Result<StopPoint> parse_stop_point(const std::string& text) {
  if (text.starts_with("mark:") && text.size() > 5) {
    return StopPoint{StopPoint::Kind::kMark, 0, text.substr(5), file_safe(text.substr(5))};
  }
  if (text.starts_with("step:")) {
    const auto steps = number_in<std::int64_t>(std::string_view(text).substr(5));
    if (!steps || *steps < 0) return unknown_point(text);
    return StopPoint{StopPoint::Kind::kStep, *steps, {}, text.substr(5)};
  }
  const auto seconds = number_in<double>(text);
  if (!seconds || !(*seconds >= 0 && *seconds <= kMaxSeconds)) return unknown_point(text);
  const auto us = static_cast<std::int64_t>(*seconds * 1e6 + 0.5);
  return StopPoint{StopPoint::Kind::kTime, us, {}, file_safe(text)};
}

StopFinder::StopFinder(std::vector<StopPoint> points)
    : points_(std::move(points)), found_(points_.size()) {}

void StopFinder::add(const log::Event& event) {
  const auto* mark = std::get_if<log::Mark>(&event.action);
  const bool is_step = std::holds_alternative<log::Step>(event.action);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (mark != nullptr && mark->name == points_[i].mark && !found_[i].time_us &&
        points_[i].kind == StopPoint::Kind::kMark) {
      found_[i] = {event.time_us, step_events_};
    }
    if (is_step && points_[i].kind == StopPoint::Kind::kTime && event.time_us <= points_[i].value) {
      ++found_[i].steps_before;
    }
  }
  if (is_step) ++step_events_;
  last_time_us_ = event.time_us;
}

Result<std::vector<std::int64_t>> StopFinder::resolve(double steps_per_second,
                                                      std::int64_t steps) const {
  const StepClock clock(steps_per_second);
  const bool stepped = step_events_ > 0;
  std::vector<std::int64_t> ends;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const StopPoint& point = points_[i];
    if (point.kind == StopPoint::Kind::kMark && !found_[i].time_us) {
      return Error{ErrorCode::kUsage, "--at mark:" + point.mark + ": the log has no such mark"};
    }
    if (point.kind == StopPoint::Kind::kTime && point.value > last_time_us_) {
      return Error{ErrorCode::kUsage, fmt::format("--at {}: the log ends at {} s", point.label,
                                                  static_cast<double>(last_time_us_) / 1e6)};
    }
    if (point.kind == StopPoint::Kind::kStep && point.value > steps) {
      return Error{ErrorCode::kUsage,
                   fmt::format("--at step:{}: the log has {} steps", point.value, steps)};
    }
    if (point.kind == StopPoint::Kind::kStep) {
      ends.push_back(point.value);
    } else if (stepped) {
      ends.push_back(std::min(found_[i].steps_before + 1, steps));
    } else {
      ends.push_back(clock.step_of(found_[i].time_us.value_or(point.value)) + 1);
    }
  }
  return ends;
}

}  // namespace pentimento

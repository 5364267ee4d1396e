#include "formats/log/parse/repair.h"

#include <fmt/format.h>

namespace pentimento::log {

namespace {
constexpr std::size_t kMostLines = 5;  // that are named
}

Event Repair::lift(std::int64_t id) {
  Event event = down_.at(id);
  event.time_us = last_us_;
  event.extensions.clear();
  std::get<Touch>(event.action).phase = TouchPhase::kUp;
  down_.erase(id);
  ++lifted_;
  return event;
}

std::vector<Event> Repair::mend(const Event& event) {
  std::vector<Event> out;
  Event mended = event;
  if (mended.time_us < last_us_) {
    mended.time_us = last_us_;
    ++times_;
  }
  last_us_ = mended.time_us;
  auto* touch = std::get_if<Touch>(&mended.action);
  if (touch == nullptr) return {mended};
  const bool is_down = down_.contains(touch->id);
  switch (touch->phase) {
    case TouchPhase::kDown:
      if (is_down) out.push_back(lift(touch->id));
      break;
    case TouchPhase::kMove:
      if (is_down) break;
      touch->phase = TouchPhase::kDown;
      ++begun_;
      break;
    case TouchPhase::kUp:
    case TouchPhase::kCancel:
      if (is_down) {
        down_.erase(touch->id);
        return {mended};
      }
      ++ends_;
      return {};
  }
  down_[touch->id] = mended;
  out.push_back(mended);
  return out;
}

std::vector<Event> Repair::finish() {
  std::vector<Event> out;
  while (!down_.empty()) out.push_back(lift(down_.begin()->first));
  return out;
}

void Repair::drop(std::int64_t line, const std::string& problem) {
  ++dropped_;
  if (lines_.size() < kMostLines) lines_.push_back(fmt::format("line {}: {}", line, problem));
}

std::vector<std::string> Repair::notes() const {
  std::vector<std::string> out;
  const auto add = [&](std::int64_t count, const char* what) {
    if (count > 0) out.push_back(fmt::format("{} {}", count, what));
  };
  add(times_, "times that ran back");
  add(begun_, "strokes without a beginning");
  add(lifted_, "strokes without an end");
  add(ends_, "ends without a stroke");
  add(dropped_, "lines dropped");
  out.insert(out.end(), lines_.begin(), lines_.end());
  return out;
}

}  // namespace pentimento::log

#include "formats/log/edit/trim.h"

#include <algorithm>

namespace pentimento::log {

void Trim::take(const Event& event) {
  if (event.time_us > end_us_) return;
  const auto* touch = std::get_if<Touch>(&event.action);
  if (event.time_us < begin_us_) {
    before_.take(event);
    if (touch == nullptr) return;
    if (touch->phase == TouchPhase::kDown || touch->phase == TouchPhase::kMove)
      open_[touch->id] = *touch;
    else
      open_.erase(touch->id);
    return;
  }
  begin();
  if (touch != nullptr) return take_touch(event, *touch);
  const Action& action = event.action;
  if (std::holds_alternative<Dry>(action) || std::holds_alternative<Clear>(action) ||
      std::holds_alternative<Load>(action))
    unit();
  if (std::holds_alternative<Undo>(action)) {
    if (done_ == 0) return;
    --done_;
    ++undone_;
  }
  if (std::holds_alternative<Redo>(action)) {
    if (undone_ == 0) return;
    --undone_;
    ++done_;
  }
  send(event);
}

void Trim::begin() {
  if (begun_) return;
  begun_ = true;
  for (const Event& event : before_.at(begin_us_)) send(event);
}

void Trim::take_touch(Event event, Touch touch) {
  const bool drawn = drawn_.count(touch.id) != 0;
  const bool ends = touch.phase == TouchPhase::kUp || touch.phase == TouchPhase::kCancel;
  if (!drawn) {
    // Its beginning is not kept: a stroke of one sample at least.
    if (ends && open_.erase(touch.id) != 0) return;
    touch.phase = TouchPhase::kDown;
    unit();
  }
  open_.erase(touch.id);
  event.action = touch;
  send(event);
  if (ends) {
    if (touch.phase == TouchPhase::kCancel && done_ > 0) --done_;
    drawn_.erase(touch.id);
  } else {
    drawn_[touch.id] = touch;
  }
}

void Trim::unit() {
  ++done_;
  undone_ = 0;
}

void Trim::send(Event event) {
  event.time_us = std::max<std::int64_t>(event.time_us - begin_us_, 0);
  hand_on(event);
}

void Trim::finish() {
  begin();
  for (auto [id, touch] : drawn_) {
    Event event;
    event.time_us = end_us_;
    touch.phase = TouchPhase::kUp;
    event.action = touch;
    send(event);
  }
}

}  // namespace pentimento::log

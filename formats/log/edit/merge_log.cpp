#include "formats/log/edit/merge_log.h"

#include <algorithm>
#include <limits>

namespace pentimento::log {

namespace {
constexpr std::size_t kFirst = 0, kOther = 1;

/// What there is only one of on a canvas.
bool is_of_the_room(const Event& event) {
  return std::holds_alternative<Gravity>(event.action) ||
         std::holds_alternative<Light>(event.action) ||
         std::holds_alternative<Environment>(event.action) ||
         std::holds_alternative<Camera>(event.action);
}

bool goes_down(const Event& event) {
  const auto* touch = std::get_if<Touch>(&event.action);
  return touch != nullptr && touch->phase == TouchPhase::kDown;
}
}  // namespace

MergeLog::MergeLog(const Header& header, const Header& other_header, OtherEvents other,
                   EventSink next)
    : EventFilter(std::move(next)),
      hands_{HandState{HandSettings(header), {}}, HandState{HandSettings(other_header), {}}},
      in_force_(header),
      other_(std::move(other)) {}

/// Whether a hand goes down that paints otherwise than the other one, which is down.
bool MergeLog::must_wait(std::size_t hand, const Event& event) const {
  return goes_down(event) && !hands_[1 - hand].down.empty() &&
         !hands_[hand].settings.changes_from(in_force_, 0).empty();
}

void MergeLog::send(std::size_t hand, Event event) {
  HandState& state = hands_[hand];
  now_us_ = std::max(now_us_, event.time_us + state.delay_us);
  event.time_us = now_us_;
  if (hand == kOther && is_of_the_room(event)) return;
  if (state.settings.take(event)) {
    // While the other hand paints, this is kept until this one does.
    if (!hands_[1 - hand].down.empty()) return;
    in_force_.take(event);
    return hand_on(event);
  }
  auto* touch = std::get_if<Touch>(&event.action);
  if (touch == nullptr) return hand_on(event);
  if (touch->phase == TouchPhase::kDown) {
    for (const Event& change : state.settings.changes_from(in_force_, now_us_)) hand_on(change);
    in_force_ = state.settings;
    state.down.insert(touch->id);
  } else if (touch->phase != TouchPhase::kMove) {
    state.down.erase(touch->id);
  }
  touch->id = 2 * touch->id + static_cast<std::int64_t>(hand);
  hand_on(event);
}

void MergeLog::send_next_of_other() {
  send(kOther, *waiting_);
  waiting_ = other_();
}

void MergeLog::send_other_until(std::int64_t time_us) {
  if (!begun_) waiting_ = other_();
  begun_ = true;
  while (waiting_ && waiting_->time_us + hands_[kOther].delay_us < time_us) {
    if (must_wait(kOther, *waiting_)) return;
    send_next_of_other();
  }
}

/// The other log goes on until its hand is up.
void MergeLog::lift_other(std::int64_t time_us) {
  while (waiting_ && !hands_[kOther].down.empty()) send_next_of_other();
  hands_[kFirst].delay_us = std::max(hands_[kFirst].delay_us, now_us_ - time_us);
}

void MergeLog::take(const Event& event) {
  send_other_until(event.time_us + hands_[kFirst].delay_us);
  if (must_wait(kFirst, event)) lift_other(event.time_us);
  send(kFirst, event);
  // A hand that waited for this one goes on now.
  if (waiting_ && hands_[kFirst].down.empty() &&
      waiting_->time_us + hands_[kOther].delay_us < now_us_)
    hands_[kOther].delay_us = now_us_ - waiting_->time_us;
}

void MergeLog::finish() {
  hands_[kFirst].down.clear();  // nobody waits for a stroke that never ends
  send_other_until(std::numeric_limits<std::int64_t>::max());
}

}  // namespace pentimento::log

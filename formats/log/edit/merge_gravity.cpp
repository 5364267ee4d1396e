#include "formats/log/edit/merge_gravity.h"

namespace pentimento::log {

void MergeGravity::take(const Event& event) {
  for (; next_reading_ < readings_.size() && readings_[next_reading_].time_us <= event.time_us;
       ++next_reading_)
    hand_on(readings_[next_reading_]);
  if (!std::holds_alternative<Gravity>(event.action)) hand_on(event);
}

}  // namespace pentimento::log

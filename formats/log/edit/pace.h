#pragma once
// How fast a log goes by.

#include <cstdint>
#include <optional>
#include <set>

#include "formats/log/edit/event_filter.h"
#include "formats/log/edit/settings.h"

namespace pentimento::log {

/// Divides all times by a factor > 0.
class Speed : public EventFilter {
 public:
  Speed(double factor, EventSink next) : EventFilter(std::move(next)), factor_(factor) {}
  void take(const Event& event) override;

 private:
  double factor_;
};

/// Cuts the time in which nobody paints. From the last event of a hand, that is any but gravity and
/// light, to the next one at most `longest_us` go by, unless a touch is down. What the sensors said
/// in the time that is cut comes at its end, the last of each.
class DropIdle : public EventFilter {
 public:
  DropIdle(std::int64_t longest_us, EventSink next)
      : EventFilter(std::move(next)), longest_us_(longest_us) {}
  void take(const Event& event) override;
  void finish() override;

 private:
  void send(Event event);
  void send_sensors();

  std::int64_t longest_us_;
  std::int64_t cut_us_ = 0;   // taken from all times so far
  std::int64_t busy_us_ = 0;  // when the hand did something, in the source's time
  std::set<std::int64_t> down_;
  Settings sensors_;  // of the time that is cut
  std::int64_t last_us_ = 0;
};

}  // namespace pentimento::log

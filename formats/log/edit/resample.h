#pragma once
// Strokes with samples at even times.

#include <cstdint>
#include <map>

#include "formats/log/edit/event_filter.h"

namespace pentimento::log {

/// Replaces the moves of each touch by moves every 1/rate seconds from its beginning, each on the
/// straight line between the source's samples; all it has is interpolated alike. Beginning and end
/// stay. What a sample has not, as pressure, the new ones have if the two beside them have it.
class Resample : public EventFilter {
 public:
  Resample(double rate_hz, EventSink next) : EventFilter(std::move(next)), rate_hz_(rate_hz) {}
  void take(const Event& event) override;
  void finish() override;

 private:
  struct EvenTouch {
    Event last;  // sample of the source
    std::int64_t begin_us = 0;
    std::int64_t next = 1;  // new sample, counted from the beginning
  };
  std::int64_t time_of(const EvenTouch& open) const;
  void send_until(const Event& event);

  double rate_hz_;
  std::map<std::int64_t, EvenTouch> open_;
  std::multimap<std::int64_t, Event> ready_;  // by time; those of one time in their order
  std::int64_t oldest_open_us() const;
  void hand_on_ready(std::int64_t before_us);
};

/// The sample between two, a share 0..1 of the way.
Touch between(const Touch& a, const Touch& b, double share);

}  // namespace pentimento::log

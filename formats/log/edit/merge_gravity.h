#pragma once
// The readings of a sensor become part of a log.

#include <vector>

#include "formats/log/edit/event_filter.h"

namespace pentimento::log {

/// Puts `readings`, in the order of their times, between the events; the log's own gravity is left
/// out. Readings after the log's last event are left out too.
class MergeGravity : public EventFilter {
 public:
  MergeGravity(std::vector<Event> readings, EventSink next)
      : EventFilter(std::move(next)), readings_(std::move(readings)) {}
  void take(const Event& event) override;

 private:
  std::vector<Event> readings_;
  std::size_t next_reading_ = 0;
};

}  // namespace pentimento::log

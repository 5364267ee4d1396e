#pragma once
// A chain of edits of a log: each takes events in their order and hands others on. Logs stream
// through; no filter keeps more than a stroke or the settings of the hand.

#include <functional>

#include "formats/log/tables/events.h"

namespace pentimento::log {

using EventSink = std::function<void(const Event&)>;

class EventFilter {
 public:
  explicit EventFilter(EventSink next) : next_(std::move(next)) {}
  virtual ~EventFilter() = default;
  virtual void take(const Event& event) = 0;
  /// Hands on what is kept back. Call once, after the last event.
  virtual void finish() {}

 protected:
  void hand_on(const Event& event) { next_(event); }

 private:
  EventSink next_;
};

}  // namespace pentimento::log

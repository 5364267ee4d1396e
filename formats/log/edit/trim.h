#pragma once
// Keeps a part of a log.

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "formats/log/edit/event_filter.h"
#include "formats/log/edit/settings.h"

namespace pentimento::log {

/// Keeps what happens from `begin_us` to `end_us`, both included; the first becomes time 0. What
/// had been set before is set at 0. A stroke that has begun before goes down at its first sample
/// that is kept; one that has not ended is lifted at its last. An undo or redo of what is not kept
/// is left out. Paint that was laid before is not on the canvas.
class Trim : public EventFilter {
 public:
  Trim(std::int64_t begin_us, std::int64_t end_us, EventSink next)
      : EventFilter(std::move(next)), begin_us_(begin_us), end_us_(end_us) {}
  void take(const Event& event) override;
  void finish() override;

 private:
  void begin();
  void take_touch(Event event, Touch touch);
  void unit();
  void send(Event event);

  std::int64_t begin_us_, end_us_;
  bool begun_ = false;
  Settings before_;
  std::map<std::int64_t, Touch> open_;   // touches that are down in the source, last sample
  std::map<std::int64_t, Touch> drawn_;  // ... and in what is kept
  std::int64_t done_ = 0, undone_ = 0;   // units that can be undone, redone
};

}  // namespace pentimento::log

#pragma once
// Strokes with as few samples as their curves need.

#include <cstdint>
#include <map>
#include <vector>

#include "formats/log/edit/event_filter.h"
#include "formats/log/edit/spline_fit.h"

namespace pentimento::log {

/// Leaves out moves that the painter's curve through the others comes within the tolerance of
/// (formats/log/edit/spline_fit.h). Samples beside other events, as a slider that moves, stay.
/// Keeps what happens while a touch is down.
class AsSpline : public EventFilter {
 public:
  AsSpline(const SplineTolerance& tolerance, EventSink next)
      : EventFilter(std::move(next)), tolerance_(tolerance) {}
  void take(const Event& event) override;
  void finish() override;

 private:
  void end_stroke(std::vector<std::size_t>& samples);

  SplineTolerance tolerance_;
  std::vector<Event> held_;
  std::vector<char> dropped_;                              // of each held event
  std::map<std::int64_t, std::vector<std::size_t>> open_;  // the held samples of each touch
};

}  // namespace pentimento::log

#pragma once
// The timeline: turns a log into cues in the order in which they act. The stamps of a stroke are
// spread over the time between its samples, and the piece of the path between two samples is known
// only when the next sample is. So the timeline reads ahead until every touch that is down has
// passed the moment of the cue that it hands out. Then the picture does not depend on how often the
// device sent samples.
//
// Memory: the timeline holds at most kMaxPending cues and events. If more happens while a touch
// stays down, the timeline no longer waits for that touch: the stamps of the touch then come late,
// when they are known.

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/base/result.h"
#include "formats/log/reader.h"
#include "formats/log/tables/events.h"
#include "replay/job/step_clock.h"
#include "replay/log/brushes.h"
#include "replay/timeline/cue.h"
#include "replay/timeline/undo.h"

namespace pentimento {

/// What a first pass over the log found. The references must outlive the timeline.
struct TimelineInput {
  const UndoTable& undo;
  const BrushTable& brushes;
  bool stepped = false;  // the log has `step` events and is stepped by them alone
  std::uint32_t first_stroke_id = 1;
};

class Timeline {
 public:
  static constexpr std::size_t kMaxPending = 1 << 16;

  /// `reader` must stand before its first event and must outlive the timeline.
  Timeline(log::Reader& reader, const TimelineInput& input);
  ~Timeline();

  /// The next cue, or nothing at the end. Errors: the reader's; kInterrupted once `cancelled`,
  /// which may be nullptr, is set and more must be read.
  Result<std::optional<Cue>> next(const std::atomic<bool>* cancelled = nullptr);
  /// The cue that next() will probably give, if it is known without reading more of the log; else
  /// nullptr. Valid until the next call.
  const Cue* peek() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pentimento

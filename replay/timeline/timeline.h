#pragma once
// From a log to cues in the order in which they act. A stroke's stamps are spread over the time
// between its samples, and the piece of a curve between two samples is known only when the sample
// after them is: so the timeline reads ahead until every touch that is down has passed the moment
// it hands out. The picture then does not depend on how often the device sent samples.
//
// Memory: it holds at most kMaxPending cues and events. A touch that stays down while more than
// that happens stops the others no longer: what it paints then is laid late, where it is found.

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

/// What a first pass over the log found; both outlive the timeline.
struct TimelineInput {
  const UndoTable& undo;
  const BrushTable& brushes;
  bool stepped = false;  // the log has `step` events and is stepped by them alone
  std::uint32_t first_stroke_id = 1;
};

class Timeline {
 public:
  static constexpr std::size_t kMaxPending = 1 << 16;

  /// `reader` stands before its first event and outlives the timeline.
  Timeline(log::Reader& reader, const TimelineInput& input);
  ~Timeline();

  /// The next cue, or nothing at the end. Errors: the reader's.
  Result<std::optional<Cue>> next();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pentimento

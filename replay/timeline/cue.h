#pragma once
// Cues: what the timeline hands to the player. They are the log's events, with touches turned into
// stamps, in the order in which they act. Each has the simulation step before which it acts.

#include <cstdint>
#include <variant>

#include "core/brush/stamp.h"
#include "formats/log/tables/events.h"

namespace pentimento {

/// A touch goes down. `slot` numbers the touches that are down at once, from 0; a new touch takes
/// the lowest free number.
struct StrokeBegin {
  int slot = 0;
  std::uint32_t stroke_id = 0;  // from 1, played strokes only
};
struct StrokeStamp {
  int slot = 0;
  Stamp stamp;
};
struct StrokeEnd {
  int slot = 0;
};

struct Cue {
  std::int64_t time_us = 0;
  std::int64_t line = 0;  // of the log, for messages
  std::int64_t step = 0;  // steps done before it acts
  /// A log::Action is never a touch, step, undo or redo: those are resolved.
  std::variant<StrokeBegin, StrokeStamp, StrokeEnd, log::Action> what;
};

}  // namespace pentimento

#pragma once
// The interface of anything that looks after a replay between two steps: when no brush touches the
// canvas, and nothing of a step is half done.

#include "core/base/result.h"

namespace pentimento {

class StepPause {
 public:
  virtual ~StepPause() = default;
  /// Called after each step that was computed and the idle ones that were skipped after it. It also
  /// sees to it that the replay stops when it is asked to. An error ends the replay.
  virtual Result<void> between_steps() = 0;
  /// Called before each cue of a step some of whose cues have been played. An error ends the replay
  /// in the middle of the step.
  virtual Result<void> within_step() = 0;
};

}  // namespace pentimento

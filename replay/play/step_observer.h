#pragma once
// The interface of anything that looks at the state after each step of a replay.

#include <cstdint>

#include "core/base/result.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

class StepObserver {
 public:
  virtual ~StepObserver() = default;
  /// Called after each step that was computed; idle steps, which change nothing, are left out.
  /// `line` is that of the last event before it in the log, 0 if there was none. `whole_canvas`:
  /// not only paint that moved or was touched may have changed since the last call; a drying, a
  /// clearing or a picture changes the whole canvas. An error ends the replay.
  virtual Result<void> stepped(const CanvasState& state, std::int64_t line, bool whole_canvas) = 0;
};

}  // namespace pentimento

#pragma once
// One cell of the base, for tests.

#include <span>

#include "core/canvas/canvas_state.h"

namespace pentimento {

/// The paper stays what it was: what is more is dried paint.
inline void set_base(CanvasState& state, int x, int y, float base_m) {
  write_base(state, x, y, std::span<const float>(&base_m, 1));
}

}  // namespace pentimento

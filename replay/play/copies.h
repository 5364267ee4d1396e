#pragma once
// Deep copies of structures that own planes.

#include "core/canvas/canvas_state.h"
#include "core/optics/lighting.h"

namespace pentimento {

CanvasState clone_state(const CanvasState& state);
Lighting clone_lighting(const Lighting& lighting);

}  // namespace pentimento

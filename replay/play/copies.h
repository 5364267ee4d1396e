#pragma once
// A deep copy of the light, which owns planes. That of a canvas is clone_state().

#include "core/canvas/canvas_state.h"
#include "core/optics/lighting.h"

namespace pentimento {

Lighting clone_lighting(const Lighting& lighting);

}  // namespace pentimento

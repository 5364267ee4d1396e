#pragma once
// The fluid that a model names.

#include <memory>

#include "core/canvas/canvas_state.h"
#include "core/fluid/scheme.h"
#include "core/model/model.h"

namespace pentimento {

/// A scheme for canvases of this geometry, with room for `layers` and `channels`.
std::unique_ptr<FluidScheme> make_scheme(SchemeKind kind, const CanvasGeometry& geometry,
                                         int layers, int channels);

}  // namespace pentimento

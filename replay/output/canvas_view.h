#pragma once
// The canvas of a simulation that is shown and dumped: its own canvas, or the detail canvas.

#include <memory>

#include "core/canvas/canvas_source.h"
#include "core/simulation/simulation.h"
#include "replay/play/replay_detail.h"

namespace pentimento {

struct CanvasView {
  std::shared_ptr<const CanvasSource> canvas;
  int detail = 1;  // fine cells per cell of the simulation
};

/// `fine` may be nullptr. Both must outlive the view, and must not change while it is read.
CanvasView make_canvas_view(const Simulation& simulation, ReplayDetail* fine, int detail);

}  // namespace pentimento

#pragma once
// What of a simulation is shown and dumped: its own canvas, or the finer one that follows it.

#include <memory>

#include "core/canvas/canvas_source.h"
#include "core/simulation/simulation.h"
#include "replay/play/replay_detail.h"

namespace pentimento {

struct CanvasView {
  std::shared_ptr<const CanvasSource> canvas;
  int detail = 1;  // fine cells per cell of the simulation
};

/// `fine` may be none. Both outlive the view, and do not change while it is read.
CanvasView make_canvas_view(const Simulation& simulation, ReplayDetail* fine, int detail);

}  // namespace pentimento

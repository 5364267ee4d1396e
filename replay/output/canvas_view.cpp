#include "replay/output/canvas_view.h"

namespace pentimento {

CanvasView make_canvas_view(const Simulation& simulation, ReplayDetail* fine, int detail) {
  if (fine == nullptr) return {std::make_shared<StateSource>(simulation.state()), 1};
  // The detail canvas keeps its source; the view only points to it.
  return {std::shared_ptr<const CanvasSource>(std::shared_ptr<void>(), &fine->source()), detail};
}

}  // namespace pentimento

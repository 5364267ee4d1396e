#include "core/fluid/conservative/solve/find_drag.h"

#include <iterator>

#include "core/fluid/conservative/solve/drag_row.h"

namespace pentimento::conservative {

void find_drag(const CanvasGeometry& geometry, float dt_s, const RunIndex& index,
               const Threads& threads, Workspace& work) {
  // The planes that hold the response before each sweep, and after the last. The last sweep writes
  // over the bed's friction, which nobody needs in that row any more: the sweeps between read it
  // there, too, and the first one in both rows beside it.
  constexpr WorkPlane NodePlanes::*kHeld[] = {&NodePlanes::friction_frac, &NodePlanes::pressure_m_s,
                                              &NodePlanes::mass_m, &NodePlanes::pressure_m_s,
                                              &NodePlanes::friction_frac};
  const auto sweep = [&](int k, NodePlanes& n, int right, int down, float across_m, const Run& r) {
    const auto at = [&](const WorkPlane& p, int side) {
      return p.row(r.y + side * down) + r.x0 + side * right;
    };
    const auto faces = [&](int side) {
      return DragFaces{at(n.depth_m, side), at(n.viscosity_m2_s, side), at(n.*kHeld[k], side)};
    };
    drag_row(faces(-1), faces(0), faces(1), at(n.friction_frac, 0), dt_s / (across_m * across_m),
             r.size(), (n.*kHeld[k + 1]).row(r.y) + r.x0);
  };
  constexpr int kSweeps = static_cast<int>(std::size(kHeld)) - 1;
  for_stages(threads, index, kSweeps, [&](int stage, const Run& r) {
    sweep(stage, work.x, 0, 1, geometry.dy_m(), r);
    sweep(stage, work.y, 1, 0, geometry.dx_m(), r);
  });
}

}  // namespace pentimento::conservative

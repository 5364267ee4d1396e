#include "core/fluid/conservative/solve/find_drag.h"

#include "core/fluid/conservative/solve/drag_row.h"

namespace pentimento::conservative {

void find_drag(const CanvasGeometry& geometry, float dt_s, const std::vector<Run>& runs,
               const Threads& threads, Workspace& work) {
  const auto sweep = [&](WorkPlane NodePlanes::*from, WorkPlane NodePlanes::*to) {
    const auto one = [&](NodePlanes& n, int right, int down, float across_m, const Run& r) {
      const auto at = [&](const WorkPlane& p, int side) {
        return p.row(r.y + side * down) + r.x0 + side * right;
      };
      const auto faces = [&](int side) {
        return DragFaces{at(n.depth_m, side), at(n.viscosity_m2_s, side), at(n.*from, side)};
      };
      drag_row(faces(-1), faces(0), faces(1), at(n.friction_frac, 0), dt_s / (across_m * across_m),
               r.size(), (n.*to).row(r.y) + r.x0);
    };
    for_runs(threads, runs, [&](const Run& r) {
      one(work.x, 0, 1, geometry.dy_m(), r);
      one(work.y, 1, 0, geometry.dx_m(), r);
    });
  };
  // The last sweep takes the place of the bed's friction, which each sweep reads.
  sweep(&NodePlanes::friction_frac, &NodePlanes::pressure_m_s);
  sweep(&NodePlanes::pressure_m_s, &NodePlanes::mass_m);
  sweep(&NodePlanes::mass_m, &NodePlanes::pressure_m_s);
  sweep(&NodePlanes::pressure_m_s, &NodePlanes::friction_frac);
}

}  // namespace pentimento::conservative

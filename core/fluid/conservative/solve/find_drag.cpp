#include "core/fluid/conservative/solve/find_drag.h"

#include <iterator>

#include "core/base/fetch_ahead.h"
#include "core/fluid/conservative/solve/drag_row.h"

namespace pentimento::conservative {

namespace {
constexpr int kRunsPerTask = 16;  // some microseconds
}  // namespace

void find_drag(const CanvasGeometry& geometry, float dt_s, const RunIndex& index,
               const Threads& threads, Workspace& work) {
  // Right faces: those above and below drag. The planes that hold the response before each sweep,
  // and after the last, which writes over the bed's friction: nobody needs that in this row any
  // more, for the sweeps between read it there, too, and the first one in both rows beside it.
  constexpr WorkPlane NodePlanes::*kHeld[] = {&NodePlanes::friction_frac, &NodePlanes::pressure_m_s,
                                              &NodePlanes::mass_m, &NodePlanes::pressure_m_s,
                                              &NodePlanes::friction_frac};
  const float dx_m = geometry.dx_m();
  const float dy_m = geometry.dy_m();
  const auto sweep = [&](int k, const Run& r) {
    NodePlanes& x = work.x;
    const auto faces = [&](int side) {
      const auto at = [&](const WorkPlane& p) { return p.row(r.y + side) + r.x0; };
      return DragFaces{at(x.depth_m), at(x.viscosity_m2_s), at(x.*kHeld[k])};
    };
    drag_row(faces(-1), faces(0), faces(1), x.friction_frac.row(r.y) + r.x0, dt_s / (dy_m * dy_m),
             r.size(), (x.*kHeld[k + 1]).row(r.y) + r.x0);
  };
  constexpr int kSweeps = static_cast<int>(std::size(kHeld)) - 1;
  for_stages(threads, index, kSweeps, [&](int stage, const Run& r) {
    if (stage == 0)
      for (const WorkPlane* p : {&work.x.pressure_m_s, &work.x.mass_m})
        fetch_row_ahead(*p, r.y, r.x0, r.x1);
    sweep(stage, r);
  });
  // Lower faces: those to the left and right drag, which lie in the same row.
  threads.for_ranges(
      0, static_cast<int>(index.runs().size()), kRunsPerTask, [&](int begin, int end) {
        DragAlongRow drag;
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
          const Run& r = index.runs()[i];
          const auto at = [&](WorkPlane& p) { return p.row(r.y) + r.x0; };
          drag.sweep(kSweeps, at(work.y.depth_m), at(work.y.viscosity_m2_s), dt_s / (dx_m * dx_m),
                     r.size(), at(work.y.friction_frac));
        }
      });
}

}  // namespace pentimento::conservative

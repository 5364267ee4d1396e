#include "core/fluid/conservative/solve/workspace.h"

namespace pentimento::conservative {
namespace {

template <typename Visit>
void for_planes(Workspace& w, const Visit& visit) {
  for (NodePlanes* n : {&w.x, &w.y})
    for (WorkPlane* p :
         {&n->mass_m, &n->first_mass_m, &n->velocity_m_s, &n->depth_m, &n->mobility_frac,
          &n->viscosity_m2_s, &n->friction_frac, &n->pressure_m_s})
      visit(*p);
  for (WorkPlane* p :
       {&w.height_m, &w.surface_m, &w.mobility_frac, &w.viscosity_m2_s, &w.crowding_m_s2})
    visit(*p);
}

}  // namespace

Workspace::Workspace(const CanvasGeometry& g) : solver(g.width, g.height) {
  int planes = 0;
  for_planes(*this, [&](const WorkPlane&) { ++planes; });
  PlaneMemory memory = WorkPlane::memory_for(planes, g.width, g.height);
  for_planes(*this, [&](WorkPlane& p) { p = WorkPlane(g.width, g.height, memory); });
  // Beyond the canvas, beside the nodes of faces that stand on its edge: slip, not a wall.
  for (int i = 0; i < g.width; ++i) x.depth_m.row(-1)[i] = x.depth_m.row(g.height)[i] = -1;
  for (int j = 0; j < g.height; ++j) y.depth_m.row(j)[-1] = y.depth_m.row(j)[g.width] = -1;
}

void Workspace::clear(const CellBox& box) {
  for_planes(*this, [&](WorkPlane& p) { p.clear(box.x0, box.x1, box.y0, box.y1); });
}

void Workspace::give_back(const CellBox& box) {
  for_planes(*this, [&](WorkPlane& p) { p.give_back(box.x0, box.x1, box.y0, box.y1); });
  solver.give_back(box.x0, box.x1, box.y0, box.y1);
}

}  // namespace pentimento::conservative

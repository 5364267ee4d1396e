#pragma once
// The planes of one step of the conservative scheme that more than one pass needs. All are zero
// where no cell is wet (wet_cells.h), those of the solver also in tiles that are not live. Nodes of
// the velocity: x nodes are the right faces of cells, y nodes the lower faces.

#include "core/canvas/canvas_state.h"
#include "core/fluid/conservative/solve/multigrid.h"
#include "core/fluid/conservative/solve/work_plane.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"

namespace pentimento::conservative {

/// The nodes of one component of the velocity.
struct NodePlanes {
  WorkPlane first_mass_m;    // paint around the node before anything moved
  WorkPlane mass_m;          // the same paint after it moved; then a drag sweep (x)
  WorkPlane velocity_m_s;    // u~, then u
  WorkPlane depth_m;         // of the face; 0 = dry or closed; negative = beyond the canvas
  WorkPlane mobility_frac;   // 1 - Phi, 0 where the film is too thin to feel gravity
  WorkPlane viscosity_m2_s;  // nu, at least the floor
  WorkPlane friction_frac;   // what the bed, then paint beside it too, leaves of a velocity
  WorkPlane pressure_m_s;    // a drag sweep (x), `held` (capillary_row.h), speed per unit slope
};

struct Workspace {
  explicit Workspace(const CanvasGeometry& g);
  /// Writes zeros on all planes but the solver's.
  void clear(const CellBox& box);
  /// Gives back the memory of all planes in a box of tiles that sleep.
  void give_back(const CellBox& box);

  NodePlanes x, y;
  WorkPlane height_m;       // h = b + d of cells
  WorkPlane surface_m;      // of cells: the height that the paint's motion leads to
  WorkPlane mobility_frac;  // of cells
  WorkPlane viscosity_m2_s;
  WorkPlane crowding_m_s2;  // of cells: pressure of too much paint, per metre of height
  Multigrid solver;
};

}  // namespace pentimento::conservative

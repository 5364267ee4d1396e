#pragma once
// The drag of paint on the paint beside it, on all faces of the awake canvas.

#include "core/base/threads.h"
#include "core/fluid/conservative/solve/stages.h"
#include "core/fluid/conservative/solve/workspace.h"

namespace pentimento::conservative {

/// Turns the friction of the faces of the runs of `index` (NodePlanes::friction_frac) from what the
/// bed leaves of a velocity in a step of `dt_s` into what the paint beside a face leaves of it,
/// too: four sweeps of drag_row. Depth and viscosity of the faces are known; mass_m and
/// pressure_m_s hold sweeps, for they are not needed any more or not yet.
void find_drag(const CanvasGeometry& geometry, float dt_s, const RunIndex& index,
               const Threads& threads, Workspace& work);

}  // namespace pentimento::conservative

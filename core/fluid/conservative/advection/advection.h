#pragma once
// Advection along one axis, by forward remap, batch by batch: of paint (depth and every channel of
// every layer), and of the momentum of velocity nodes. All of it uses the velocities at the start
// of the step.

#include "core/canvas/canvas_state.h"
#include "core/canvas/cell_box.h"
#include "core/fluid/conservative/solve/workspace.h"
#include "core/fluid/conservative/tiles/wet_cells.h"
#include "core/fluid/scheme.h"

namespace pentimento::conservative {

/// Whether an axis moves first in a step or second.
enum class Turn { kFirst, kSecond };

/// Fills first_mass_m of both components: the paint around each node before anything moves, which
/// is the mean of the depths of its two cells.
void fill_node_masses(const CanvasState& state, const WetCells& wet, const Threads& threads,
                      Workspace& work);

/// Moves mass and velocity of the nodes of both components along `axis`. The first turn takes the
/// masses of fill_node_masses() and the velocities of the state; the second turn takes what the
/// first turn left.
void advect_momentum(const CanvasState& state, const StepInput& in, Axis axis, Turn turn,
                     const WetCells& wet, Workspace& work);

/// Moves depth and every channel of every layer along one axis. The depth moves with the velocity
/// plus half of the brush's push. A layer moves with Model::layer_speed times the velocity plus the
/// push, both times the height of the layer's middle in the film (R18, layer_speed_row.h). Of layer
/// 0 only what exceeds the residue moves (R19).
void advect_paint_along_x(CanvasState& state, const StepInput& in, const WetCells& wet);
void advect_paint_along_y(CanvasState& state, const StepInput& in, const WetCells& wet);
inline void advect_paint(CanvasState& state, const StepInput& in, Axis axis, const WetCells& wet) {
  axis == Axis::kX ? advect_paint_along_x(state, in, wet) : advect_paint_along_y(state, in, wet);
}

}  // namespace pentimento::conservative

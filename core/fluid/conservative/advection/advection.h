#pragma once
// One axis of one step's transport: paint (depth and every channel of every layer) and the
// momentum of velocity nodes, by forward remap, batch by batch. Velocities are those at the start
// of the step throughout.

#include "core/canvas/canvas_state.h"
#include "core/canvas/cell_box.h"
#include "core/fluid/conservative/solve/workspace.h"
#include "core/fluid/conservative/tiles/sleep_tiles.h"
#include "core/fluid/scheme.h"

namespace pentimento::conservative {

/// The axis that moves first in a step, or the other.
enum class Turn { kFirst, kSecond };

/// Fluid around each node from the depths, before any transport: the mean of the two cells.
void fill_node_masses(const CanvasState& state, const SleepTiles& tiles, const Threads& threads,
                      Workspace& work);

/// Moves mass and velocity of both components' nodes along `axis`: the first time those of
/// fill_node_masses and of the state, then what the first time left.
void advect_momentum(const CanvasState& state, const StepInput& in, Axis axis, Turn turn,
                     const SleepTiles& tiles, Workspace& work);

/// The plain way to do it, along either axis: batch after batch, each in flat arrays. The same
/// bits; along y, advect_momentum goes row by row (remap_stream.h).
void advect_momentum_in_batches(const CanvasState& state, const StepInput& in, Axis axis, Turn turn,
                                const SleepTiles& tiles, Workspace& work);

/// Moves depth with the velocity plus half the brush's push, and every channel of a layer with
/// Model::layer_speed velocities plus the push, both times the height of the layer's middle in the
/// film (R18, layer_speed_row.h). Of layer 0, only what exceeds the residue moves (R19).
void advect_paint_along_x(CanvasState& state, const StepInput& in, const SleepTiles& tiles);
void advect_paint_along_y(CanvasState& state, const StepInput& in, const SleepTiles& tiles);
inline void advect_paint(CanvasState& state, const StepInput& in, Axis axis,
                         const SleepTiles& tiles) {
  axis == Axis::kX ? advect_paint_along_x(state, in, tiles)
                   : advect_paint_along_y(state, in, tiles);
}

}  // namespace pentimento::conservative

#pragma once
// One axis of one step's transport: paint (depth and every channel of every layer) and the
// momentum of velocity nodes, by forward remap, block by block. Velocities are those at the start
// of the step throughout.

#include "core/canvas/canvas_state.h"
#include "core/canvas/cell_box.h"
#include "core/fluid/conservative/solve/workspace.h"
#include "core/fluid/conservative/tiles/tiles.h"
#include "core/fluid/scheme.h"

namespace pentimento::conservative {

/// The axis that moves first in a step, or the other.
enum class Turn { kFirst, kSecond };

/// Fluid around each node from the depths, before any transport: the mean of the two cells.
void fill_node_masses(const CanvasState& state, const Tiles& tiles, const Threads& threads,
                      Workspace& work);

/// Moves mass and velocity of both components' nodes along `axis`: the first time those of
/// fill_node_masses and of the state, then what the first time left.
void move_momentum(const CanvasState& state, const StepInput& in, Axis axis, Turn turn,
                   const Tiles& tiles, Workspace& work);

/// The plain way to do it, along either axis: block after block, each in flat arrays. The same
/// bits; along y, move_momentum goes row by row (remap_stream.h).
void move_momentum_in_blocks(const CanvasState& state, const StepInput& in, Axis axis, Turn turn,
                             const Tiles& tiles, Workspace& work);

/// Moves depth with the velocity plus half the brush's push, and every channel of a layer with
/// Model::layer_speed velocities plus the push, both times the height of the layer's middle in the
/// film (R18, layer_speed_row.h). Of layer 0, only what exceeds the residue moves (R19).
void move_paint_along_x(CanvasState& state, const StepInput& in, const Tiles& tiles);
void move_paint_along_y(CanvasState& state, const StepInput& in, const Tiles& tiles);
inline void move_paint(CanvasState& state, const StepInput& in, Axis axis, const Tiles& tiles) {
  axis == Axis::kX ? move_paint_along_x(state, in, tiles) : move_paint_along_y(state, in, tiles);
}

}  // namespace pentimento::conservative

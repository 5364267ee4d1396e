#pragma once
// What a canvas costs: the numbers that estimates are made of (docs/bench/poster.md has how they
// were measured).

#include <cstdint>

namespace pentimento {

struct DetailCost {
  // Memory of the finer canvas, bytes.
  double wet_cell = 8;      // depth and base, in a tile with wet paint
  double pigment_cell = 4;  // for each layer and channel that the tile has
  double dried_cell = 12;   // reflectance, once something has dried in the tile
  double base_cell = 4;     // base, in a tile that is dry
  double bare_tile = 16;    // where there never was paint
  // Processor time, as multiples of what a cell of the guide that is awake takes in a step.
  double stamp = 370;                // a stamp on the guide, whatever its size: mostly one thread's
  double stamped_cell = 1.0;         // a cell of the guide under a stamp
  double fine_stamp = 700;           // a stamp on the finer canvas, whatever its size
  double stamped_cell_steps = 0.28;  // a fine cell under a stamp
  double moved_cell_steps = 0.18;    // a fine cell of an awake tile, per step
  double canvas_cell = 0.5;          // a fine cell hashed, per stop
  double picture_pixel = 0.8;        // shaded and encoded
};

}  // namespace pentimento

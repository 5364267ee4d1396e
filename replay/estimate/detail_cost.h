#pragma once
// What a canvas costs: the numbers that estimates are made of (docs/bench/poster.md has how they
// were measured).

#include <cstdint>

namespace pentimento {

/// Memory of the detail canvas, bytes.
struct DetailCost {
  std::int64_t cell = 4;  // of a plane: depth, relief, a layer of a channel, a band that dried
  // Rows of a plane count by so many bytes. A plane has all its memory from the start; but not all
  // channels come that may come, and with whole planes more was foreseen than found.
  std::int64_t page = 4096;
  std::int64_t bare_tile = 16;  // where there never was paint
};

/// Processor time, as multiples of what a wet cell of a small canvas takes in a step.
struct TimeCost {
  // The guide.
  double awake_cell = 1.3;         // a cell of a tile where paint was laid lately, per step
  double tilted_cell = 0.92;       // a cell of a wet tile while the canvas is tilted, per step
  double stamped_cell = 0.15;      // a cell under a stamp
  double stamp = 40;               // a stamp, whatever its size
  double guide_shared_frac = 0.2;  // that all threads do together
  // What a detail canvas of any size takes: notes of stamps, blocks that are corrected.
  double followed_cell = 16.3;        // a cell of the guide under a stamp
  double followed_tilted_cell = 4.3;  // a cell of the guide in wet tiles while tilted, per step
  double followed_shared_frac = 0.5;
  // Its cells.
  double fine_awake_cell = 0.1;       // a fine cell of awake tiles, per step
  double fine_awake_channel = 0.057;  // each channel that its tile has wet
  double fine_tilted_cell = 0.4;      // a fine cell of wet tiles while tilted, per step
  double canvas_cell = 1;             // a fine cell hashed, per stop
  double picture_pixel = 4.7;         // shaded and encoded
  double fine_shared_frac = 0.9;
};

}  // namespace pentimento

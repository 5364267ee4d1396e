#pragma once
// Blocks that owe paint but have (almost) none to scale up: the guide's own spreading reached a
// cell that the detail canvas did not.

#include <span>
#include <vector>

#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// A block, what it must hold on average, and the fine cells it gets.
struct UncoveredBlock {
  int x = 0, y = 0;  // of the guide
  int plane = 0;     // which of those locked together
  float mean = 0;
  std::vector<float> value;  // factor x factor, filled by fill_uncovered
};

/// Decides where the block's paint lies: as an extension of what the fine cells across its borders
/// hold, fading away from them
///   e = sum over the four sides of (value across) (1 - distance / k)^2
/// pigment only where the block has depth d, w = d (e + a thirtieth of its mean); depth w = e;
/// pigment with nothing across, w = d; else evenly. Reads the canvas as it is; writes nothing to
/// it. Source: ours. Departs from it: nothing.
void fill_uncovered(DetailCanvas& canvas, const WetPlane& q, UncoveredBlock& block);

/// Writes the block's cells.
void store_uncovered(DetailCanvas& canvas, const WetPlane& q, const UncoveredBlock& block);

}  // namespace pentimento

#pragma once
// Uncovered blocks: they must hold paint, but have almost none that could be scaled up. The guide's
// paint spread to a cell that the paint of the detail canvas did not reach.

#include <span>
#include <vector>

#include "core/detail/store/detail_canvas.h"

namespace pentimento {

/// A block, what it must hold on average, and the fine cells it gets.
struct UncoveredBlock {
  int x = 0, y = 0;  // of the guide
  int plane = 0;     // index among the planes that are locked
  float mean = 0;
  std::vector<float> value;  // factor x factor, set by fill_uncovered()
};

/// Decides where the block's paint lies: it extends what the fine cells across the borders hold,
/// and fades away from them.
///   e = sum over the four sides of (value across) (1 - distance / k)^2
/// The weight of a cell is w = e for depth. For pigment it is w = d (e + a thirtieth of its mean),
/// d the cell's depth, or w = d if nothing lies across. If these are all 0, w = e for pigment too.
/// If those are 0 as well, the paint is spread evenly. The function only reads the canvas. Source:
/// ours. Departs from it: nothing.
void fill_uncovered(DetailCanvas& canvas, const WetPlane& q, UncoveredBlock& block);

/// Writes the values that fill_uncovered() found into the block's cells.
void store_uncovered(DetailCanvas& canvas, const WetPlane& q, const UncoveredBlock& block);

}  // namespace pentimento

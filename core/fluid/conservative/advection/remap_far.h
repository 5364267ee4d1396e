#pragma once
// Far cells: cells of a batch whose image covers any number of cells (remap_plan.h).

#include <functional>
#include <vector>

#include "core/fluid/conservative/advection/remap_rows.h"

namespace pentimento::conservative {

/// A far cell with its linear profile, as it was before anything moved.
struct FarCell {
  int at = 0;                      // along its line
  int lane = 0;                    // which line of the batch
  float edge_lo = 0, edge_hi = 0;  // how far its edges move, in cells
  float value = 0;                 // amount
  float slope = 0;                 // limited difference across the cell
};

/// The cells of a line, of which the first is cell `before` of a longer one. Far cells are counted
/// along that, for a place in single precision is rounded by its size.
struct FarLine {
  int cells = 0;
  int before = 0;
};

/// Gives the place where cell `at` of line `lane` is stored.
using FarTarget = std::function<float&(int at, int lane)>;

/// The limited difference across cell i, which is a far cell's slope.
float far_slope(const RemapOptions& options, const ThreeRows& value, int i);

/// Takes the cells `far` of a single line. Cell i lies between the edges i and i + 1 of `edge`.
std::vector<FarCell> take_far_cells(const std::vector<int>& far, const float* edge,
                                    const RemapOptions& options, const ThreeRows& value);

/// Adds each far cell where it lands.
///   image [x_lo + D_lo, x_hi + D_hi], cut at the line's ends; ends swapped if reversed; each
///   covered cell gets the part of the linear profile mapped onto it, the last one what is left
/// Scheme: piecewise linear, 2nd order where smooth; monotone.
/// Stable: any displacement.
/// Source: Lauritzen et al. 2010 (remap_plan.h).
/// Departs from it: moved parts are whole quanta; an image of no length falls into one cell.
void put_far_cells(const std::vector<FarCell>& far, const FarLine& line, float rounder,
                   const FarTarget& value);

/// The same for momentum: each part carries `speed[k]`, the velocity of far cell k.
void put_far_momentum(const std::vector<FarCell>& far, const std::vector<float>& speed,
                      const FarLine& line, const FarTarget& value, const FarTarget& momentum);

}  // namespace pentimento::conservative

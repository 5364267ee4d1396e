#pragma once
// The plan of a remap: where the parts of each cell of a line go when its two edges move. All
// quantities that move with the same velocity share a plan.

#include <cmath>

namespace pentimento::conservative {

/// Which shares of a cell's length go over its low edge (tau_lo) and over its high edge (tau_hi),
/// both in [0,1]. A far cell is one whose parts reach further than the next cell, or whose edges
/// change order: it passes nothing, and put_far_cells() moves it as a whole.
struct RemapShares {
  float lo, hi;  // tau_lo, tau_hi
  float near;    // 1, or 0 for a far cell
};

/// Finds them from how far the cell's edges move, in cells. Inlined into kernels.
///   len = 1 + D_hi - D_lo;  tau_lo = max(-D_lo, 0) / len;  tau_hi = max(D_hi, 0) / len
/// Scheme: exact for the moved edges x + D, D in cells. No order of its own.
/// Stable: any D; cells with |D| > 1 or len < 1/64 are marked, not moved.
/// Source: forward remap of moved cell edges; Lauritzen, Nair, Ullrich, J. Comput. Phys. 229 (2010)
///   1401-1424, sec. 2, in one dimension.
/// Departs from it: edges move with the velocity at their start (first order in time).
inline RemapShares remap_shares(float edge_lo, float edge_hi) {
  constexpr float kMinLength = 1.0f / 64;  // shorter images are moved as points
  const float length = 1 + edge_hi - edge_lo;
  const float low = std::abs(edge_lo);
  const float high = std::abs(edge_hi);
  const float farther = low > high ? low : high;
  // Masks as numbers: of conditions that follow from one another the compiler makes branches.
  const float near = (length >= kMinLength ? 1.0f : 0.0f) * (farther <= 1 ? 1.0f : 0.0f);
  const float inverse = near / (length > kMinLength ? length : kMinLength);
  const float below = 0.5f * (low - edge_lo);  // -lo where lo < 0, else 0, without rounding
  const float above = 0.5f * (high + edge_hi);
  return {(below < 1 ? below : 1.0f) * inverse, (above < 1 ? above : 1.0f) * inverse, near};
}

/// Finds the shares of a row.
void plan_remap_row(const float* edge_lo, const float* edge_hi, int cells, float* tau_lo,
                    float* tau_hi, float* stay);
/// How many cells of a row are far cells.
int count_far_row(const float* stay, int cells);

}  // namespace pentimento::conservative

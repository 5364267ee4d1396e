#pragma once
// Where the parts of each cell of a batch go when its two edges move: shared by every quantity
// that moves with the same velocity.
//
// A batch is a flat array of n cells whose neighbours along the axis of motion lie `step` apart:
// step 1 for a row that moves along x; the width of a strip of columns that moves along y.

#include <vector>

namespace pentimento::conservative {

/// Moved shares of a batch's cells: tau_lo of a cell goes over its low edge, tau_hi over its high
/// edge, both in [0,1] by length. stay is 1, or 0 for cells whose parts reach further than the
/// next cell or whose edges change order: remap_scatter moves these whole.
struct RemapPlan {
  int step = 1;
  std::vector<float> edge;  // n + step displacements in cells; cell i has edges i and i + step
  std::vector<float> tau_lo, tau_hi, stay;  // n
  std::vector<int> far;                     // cells with stay = 0, ascending

  void resize(int cells, int step_cells);
  int cells() const { return static_cast<int>(stay.size()); }
};

/// Fills all but `edge` from it.
void plan_remap(RemapPlan& plan);

/// One row of it.
///   len = 1 + D_hi - D_lo;  tau_lo = max(-D_lo, 0) / len;  tau_hi = max(D_hi, 0) / len
/// Scheme: exact for the moved edges x + D, D in cells. No order of its own.
/// Stable: any D; cells with |D| > 1 or len < 1/64 are marked, not moved.
/// Source: forward remap of moved cell edges; Lauritzen, Nair, Ullrich, J. Comput. Phys. 229 (2010)
///   1401-1424, sec. 2, in one dimension.
/// Departs from it: edges move with the velocity at their start (first order in time).
void plan_remap_row(const float* edge_lo, const float* edge_hi, int cells, float* tau_lo,
                    float* tau_hi, float* stay);
/// How many cells move far.
int count_far_row(const float* stay, int cells);

}  // namespace pentimento::conservative

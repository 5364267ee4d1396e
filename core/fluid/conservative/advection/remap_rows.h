#pragma once
// The kernels of the remap of one quantity, row by row, with the neighbours of each cell in rows of
// their own. If paint moves along y, these are the rows above and below; if paint moves along x,
// they are the same row shifted by a cell.

#include "core/fluid/conservative/advection/remap_plan.h"

namespace pentimento::conservative {

struct RemapOptions {
  bool superbee = false;
  float rounder = 0;  // quantum.h; 0 = no rounding of the moved parts
};

/// A quantity in a row of cells, and in the cells before and after each of them along the motion.
/// At a wall the cell itself takes the place of the missing neighbour.
struct ThreeRows {
  const float* before;
  const float* here;
  const float* after;
};

/// A quantity at the low edges and at the high edges of a row.
struct LoHi {
  const float* lo;
  const float* hi;
};

/// Finds what n cells pass over their two edges.
///   out_hi = tau_hi (m + s/2 (1 - tau_hi)), out_lo = tau_lo (m - s/2 (1 - tau_lo)), rounded to
///   quanta and never more than there is; s: limited difference of the neighbours
/// Scheme: piecewise linear, 2nd order where smooth; monotone.
/// Stable: any displacement the plan allows.
/// Source: Lauritzen et al. 2010 (remap_plan.h), profiles of van Leer 1977 (limiter.h).
/// Departs from it: moved parts are whole quanta, so that sums are exact.
void flux_rows(const RemapOptions& options, const LoHi& tau, const ThreeRows& value, int n,
               float* out_lo, float* out_hi);

/// What leaves a row of cells, and what comes from the neighbours.
struct Parts {
  const float* hi_before;
  const float* hi;
  const float* lo;
  const float* lo_after;
};

/// value = stay value - hi - lo + (hi_before + lo_after), in place. If all are multiples of the
/// quantum and below 2^24 quanta, sums are exact and nothing becomes negative.
void gather_rows(const float* stay, const Parts& parts, int n, float* value);
/// The same for what moves of cells that hold something back: value = what `moving` becomes + held.
void gather_beside_rows(const float* stay, const Parts& parts, const float* moving,
                        const float* held, int n, float* value);

/// Writes copies of the end cells before and after the n cells of a row: no slope across its ends.
void mirror_ends(float* value, int n);

}  // namespace pentimento::conservative

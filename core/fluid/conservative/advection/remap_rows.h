#pragma once
// The kernels of the remap, with the neighbours of each cell in rows of their own. If paint moves
// along y, these are the rows above and below; if paint moves along x, they are the same row
// shifted by a cell. Equations, scheme and sources are those of remap_row.h, and the bits are the
// same.

#include "core/fluid/conservative/advection/remap_row.h"

namespace pentimento::conservative {

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

/// Finds what n cells pass over their two edges (remap_flux_row()).
void flux_rows(const RemapOptions& options, const LoHi& tau, const ThreeRows& value, int n,
               float* out_lo, float* out_hi);

/// What leaves a row of cells, and what comes from the neighbours.
struct Parts {
  const float* hi_before;
  const float* hi;
  const float* lo;
  const float* lo_after;
};

/// value = stay value - hi - lo + (hi_before + lo_after), in place.
void gather_rows(const float* stay, const Parts& parts, int n, float* value);
/// The same for what moves of cells that hold something back: value = what `moving` becomes + held.
void gather_beside_rows(const float* stay, const Parts& parts, const float* moving,
                        const float* held, int n, float* value);

}  // namespace pentimento::conservative

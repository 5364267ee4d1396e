#pragma once
// The kernels of the remap (remap_row.h, remap_momentum.h) with the neighbours of each cell in rows
// of their own: the rows above and below where paint moves along y, the same row shifted by a cell
// where it moves along x. Equations, scheme and sources are theirs; the bits are the same.

#include "core/fluid/conservative/advection/remap_row.h"

namespace pentimento::conservative {

/// A quantity of a row of cells, and of the cells before and after each along the motion. At a wall
/// the missing cell is the cell itself.
struct ThreeRows {
  const float* before;
  const float* here;
  const float* after;
};

/// Something of a row's low edges and high edges.
struct LoHi {
  const float* lo;
  const float* hi;
};

/// What n cells pass over their two edges.
void flux_rows(const RemapOptions& options, const LoHi& tau, const ThreeRows& value, int n,
               float* out_lo, float* out_hi);

/// The momentum that goes with the mass `mass_out`.
void momentum_flux_rows(const LoHi& tau, const ThreeRows& velocity, const LoHi& mass_out, int n,
                        float* out_lo, float* out_hi);

/// What leaves a row of cells, and what comes from its neighbours.
struct Parts {
  const float* hi_before;
  const float* hi;
  const float* lo;
  const float* lo_after;
};

/// value = stay value - hi - lo + (hi_before + lo_after), in place.
void gather_rows(const float* stay, const Parts& parts, int n, float* value);

}  // namespace pentimento::conservative

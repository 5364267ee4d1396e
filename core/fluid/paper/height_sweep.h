#pragma once
// Solves the height system by Jacobi sweeps (R9) and keeps the height within its limits.

#include "core/fluid/paper/planes.h"

namespace pentimento::paper {

/// One Jacobi sweep of the height system over row y.
///   h' = centre + left h(x-1) + right h(x+1) + up h(y-1) + down h(y+1)
/// Scheme: Jacobi, started at h of the old step. Converges: the weights' magnitudes sum to at most
/// 1 (build_height_system_row). After 4 sweeps a cosine of 16 cells in a film of 0.5 mm stands at
/// 0.8632 of its amplitude, converged at 0.7211. Source: R9 (Stuyck et al. 2016, section 5.1).
/// Departures: none; the number of sweeps is a parameter.
void sweep_height_row(const Stencil& system, const Field<float>& height_m, int y, Columns cells,
                      float* out);

/// Keeps the film of row y between bare paper and the largest depth: b <= h <= b + max_medium. The
/// solve keeps neither bound; without them volume below the paper would be owed, and converging
/// stiff paint (Phi = 1, nothing opposes it) would pile up without end. Makes and loses volume.
void limit_height_row(const Field<float>& base_m, float max_medium_m, int y, Columns cells,
                      float* height_m);

}  // namespace pentimento::paper

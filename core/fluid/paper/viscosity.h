#pragma once
// The implicit viscosity (R11, R13).

#include "core/fluid/paper/planes.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

/// Builds the viscous system of row y, divided by its diagonal, in `planes.system`.
///   u+ - dt nu(theta) (u+_xx + u+_yy) = u*, likewise v
/// Scheme: implicit, 1st order in time, 2nd in space. Stable for any nu: the weights are positive
/// and sum to less than 1. (Explicit it would need nu <= 1 / (2 dt (1/dx^2 + 1/dy^2)) = 1.37e-5
/// m^2/s, 728 times less than nu_max.) Source: R11, R13, A9 (Stuyck et al. 2016, equation 4).
/// Departures: implicit, where the paper is silent. A neighbour without fluid pulls nothing
/// (Neumann).
void build_viscosity_row(const StepConstants& k, int y, Columns cells, Planes& planes);

/// One Jacobi sweep of that system over row y.
///   u' = centre u* + left u(x-1) + right u(x+1) + up u(y-1) + down u(y+1)
/// Scheme: Jacobi, started at u*, as many sweeps as for the height (A9). Converges: see above.
/// Source: A9. Departures: none. `right_side` is u*.
void sweep_viscosity_row(const Stencil& system, const Velocity& right_side,
                         const Velocity& velocity, int y, Columns cells, float* out_u,
                         float* out_v);

}  // namespace pentimento::paper

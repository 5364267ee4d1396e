#pragma once
// The linear system of the viscosity, for one component of the velocity.

namespace pentimento::conservative {

/// Nodes of a row and of the two rows beside it. They are readable one node to each side.
struct ViscousNodes {
  const float* depth_above;
  const float* depth;  // > 0 wet, 0 dry or closed, < 0 beyond the canvas
  const float* depth_below;
  const float* viscosity_m2_s;
  const float* viscosity_below;
  const float* velocity_m_s;  // u~
};

/// Rows of the system of multigrid_rows.h. The right side, u~, is also the first guess.
struct SystemRow {
  float* cx;
  float* cy;
  float* zero_order;
  float* rhs;
};

/// Builds (1 - dt div nu grad) u = u~ on wet nodes.
///   coupling of two wet nodes: dt/dx^2 (nu_a + nu_b)/2; a dry neighbour holds u = 0 and adds
///   dt/dx^2 nu to the zero-order term; beyond the canvas: slip, nothing
/// Scheme: backward Euler in time, 5 points in space, 2nd order where nu is smooth.
/// Stable: any dt; the system is symmetric and positive definite.
/// Source: R13 with A9 (Stuyck et al. 2016, equation 4).
/// Departs from it: div(nu grad u) in place of nu times the Laplacian, which is not symmetric where
///   nu varies, and on which multigrid diverges.
/// `per_dx2`, `per_dy2`: dt/dx^2, dt/dy^2.
void viscous_row(const ViscousNodes& nodes, float per_dx2, float per_dy2, int n,
                 const SystemRow& out);

}  // namespace pentimento::conservative

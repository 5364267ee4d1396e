#pragma once
// The linear system of the new height, and the velocities that follow from the height.

#include <array>

namespace pentimento::conservative {

/// The faces around a row of cells: depth and u* of the right faces (readable one face to the left,
/// too), of the faces above and of the faces below.
struct FluxRow {
  const float* depth_x;
  const float* velocity_x;
  const float* depth_above;
  const float* velocity_above;
  const float* depth_below;
  const float* velocity_below;
};

/// rhs = h - dt div(d_f u*), in cells of a row.
/// Scheme: centred on the staggered grid, 2nd order in space.
/// Stable: as part of the implicit step (pressure_row), any dt.
/// Source: Casulli, Int. J. Numer. Methods Fluids 30 (1999) 425-440; the paper's equation 2 is its
///   collocated, non-conservative form.
/// Departs from it: the result only gives the pressure; depth itself moves by the remap alone.
void height_rhs_row(const FluxRow& f, const float* height_m, float dt_per_dx, float dt_per_dy,
                    int n, float* rhs);

struct Crowding {
  float from_m = 0;     // depth at which it starts
  float range_m = 1;    // over which it rises to `most`
  float most_m_s2 = 0;  // Model::crowding_m_s2
};

/// Crowding: pressure of paint that is deeper than a canvas carries.
///   crowding = most clamp((max(d, h' - b) - from) / range, 0, 1); h' - b: depth to come
/// `crowding_m_s2` has h' on entry.
/// Scheme: pointwise, from the depth that would come without it.
/// Stable: enters an implicit solve.
/// Source: ours. Without it, paint that feels no gravity across the canvas (stiff, face down, free
///   fall) is a pressureless fluid and piles up without bound where it converges.
/// Departs from it: nothing.
void crowding_row(const Crowding& c, const float* depth_m, const float* base_m, int n,
                  float* crowding_m_s2);

/// A row of faces, and the cells a and b on their two sides.
struct PressureRow {
  const float* depth_m;        // of the face
  const float* mobility_frac;  // of the face
  const float* friction_frac;
  const float* crowding_a;
  const float* crowding_b;
};

/// Coefficients of the height equation on faces.
///   K = dt friction (mobility (max(gz, 0) + held) + max(crowding_a, crowding_b));
///   coupling = K d_f dt/dx^2
/// `pressure_m_s` has held (capillary_row.h) on entry and K on return.
/// Scheme: backward Euler: h' - dt div(d_f K grad h') = rhs.
/// Stable: any dt; symmetric, positive definite.
/// Source: R6, R7 (A13: never negative); Casulli 1999.
/// Departs from it: crowding; held.
void pressure_row(const PressureRow& f, float dt_gravity_m_s, float dt_s, float dt_per_dx2, int n,
                  float* pressure_m_s, float* coupling);

/// u = u* - K (h'_b - h'_a) / dx; then |u| <= cap, dry faces stand.
/// Scheme: the other half of pressure_row's step.
/// Stable: any dt.
/// Source: R10, R11 (Stuyck et al. 2016, equation 4).
/// Departs from it: the cap, on each component, is ours: no paint falls faster than twice the
///   fastest wave.
struct FinishRow {
  const float* depth_m;  // of the face
  const float* pressure_m_s;
  const float* height_a;
  const float* height_b;
};
/// `velocity_m_s`: u*, becomes u.
void finish_row(float cap_m_s, const FinishRow& f, float per_dx, int n, float* velocity_m_s);

/// A row of faces of one component, and the same component at the faces next to them across its
/// direction: of right faces those above and below, of lower faces those to the left and right.
struct NodesBeside {
  const float* here_m_s;
  const float* before_m_s;
  const float* after_m_s;
};
/// The other component around a row of faces: the nodes on their one side and those on their other.
/// On each side lie, across the direction of the other component, one node before the face, the two
/// next to it, and one after.
struct NodesAround {
  std::array<const float*, 4> one_side_m_s;
  std::array<const float*, 4> other_side_m_s;
};
/// out = u where max(w^2, (u/2)^2) + v^2 >= threshold^2, else 0: slow paint stands.
///   w = (u_before + 2 u + u_after) / 4
///   v = mean over both sides of (before + 3 first + 3 second + after) / 8: the mean of the other
///   component's own w around the face
/// Scheme: pointwise.
/// Stable: any dt. A face that does not move itself moves only where the paint around it does, so a
///   canvas comes to rest.
/// Source: R14.
/// Departs from it: the speed is that of paint and of what runs beside it, so that the border of
///   paint that stands has no teeth one cell wide. From twice the threshold on paint runs alone.
void stand_row(float threshold_m_s, const NodesBeside& beside, const NodesAround& around, int n,
               float* out_m_s);

}  // namespace pentimento::conservative

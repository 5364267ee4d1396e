#pragma once
// Surface tension inside a film: paint flows from where its surface bulges to where it is hollow.
// The height solve has the other half (height_row.h).

namespace pentimento::conservative {

/// Slope at which a film ends on the canvas: 56 degrees. Oil wets a primed canvas; paint with
/// pigment in it less so.
inline constexpr float kContactSlope = 1.5f;

/// Weights of the faces between the cells a and b of a row: per_d2 between two films, -2 per_d2 at
/// the edge of a film, for the edge is half a cell away; 0 between bare cells.
/// A cell with less than `least_film_m` of paint has no surface of its own; a film ends there, and
/// contact_line.h holds its edge.
void film_weight_row(const float* depth_a, const float* depth_b, float least_film_m, float per_d2,
                     int n, float* weight);

/// Heights of a row of cells and of the two rows beside it (readable one cell to each side), and
/// the weights of the faces around its cells.
struct SurfaceRow {
  const float* above_m;
  const float* here_m;
  const float* below_m;
  const float* base_m;        // what the cells of the middle row stand on
  const float* weight_x;      // of the right faces; readable one face to the left
  const float* weight_above;  // 1/m^2
  const float* weight_below;
};

/// How far a surface falls on the half cell to the film's edge.
struct EdgeDrop {
  float x_m = 0;  // at most: kContactSlope / 2 cells
  float y_m = 0;
  float carried_m = 1;  // c: the deepest film that its surface carries, > 0
};

/// The curvature of the surface, in m^2/s^2 as a head: s lap h.
/// At an edge of the film the surface comes down to the canvas, or as far as kContactSlope allows;
/// beside bare canvas that stands higher, as at the shore of a lake, and at a wall it has no slope.
/// Nor where the edge is deeper than 0.6 c: it ends in a front that contact_line.h holds. From 0.3
/// c on the drop fades. Behind such an edge the film is so deep that it does not have all of its
/// tension, which then has no potential: paint would circulate there for ever.
/// Scheme: 5 points, 2nd order; 1st order at an edge.
/// Stable: alone it does nothing. With edges on any sides, -lap has no eigenvalue above that of the
/// shortest wave, L (capillary_force_row).
/// Source: Young and Laplace, p = -sigma lap h for small slopes; Orchard 1962.
/// Departs from it: the slope's square is left out, so steep walls count as more curved.
void curvature_row(const SurfaceRow& surface, const EdgeDrop& most, float tension_m3_s2, int n,
                   float* head_m2_s2);

/// The surface that the paint's motion leads to, as far as the explicit half of the tension trusts
/// it. `surface_m` holds the one of the whole step (height_rhs_row) and becomes
///   h + r (surface - h),  r = 0.9 where d <= c, 0.5 where d >= 2 c, linear between
/// Thin films creep: their motion goes on. With r = 0, waves of a few cells on films of a few
/// millimetres decay several times too slowly, for the implicit half lags a step behind. Deep films
/// swing: with r = 0.7, puddles of a centimetre break up.
/// Scheme: pointwise. Stable: alone it does nothing.
/// Source: measured (docs/numerics.md). Departs from it: nothing.
void foresee_row(const float* depth_m, const float* height_m, float carried_m, int n,
                 float* surface_m);

struct CapillaryForce {
  float dt_s = 0;
  float per_d_per_m = 0;      // 1 / distance of the two cells
  float tension_m3_s2 = 0;    // s = sigma / rho
  float stiffest_per_m2 = 0;  // L = 4/dx^2 + 4/dy^2: eigenvalue of -lap for the shortest wave
  float stiffest = 300;       // the largest dt^2 K d s L^2: deeper films have less tension
  float hanging_m_s2 = 0;     // gravity away from the canvas, >= 0
  float sagging_m_s2 = 0;     // gravity under which a heap sags, >= 0
  float carried_m = 1;        // c: the deepest film that its surface carries, > 0
};

/// A row of faces between the cells a and b.
struct CapillaryFaces {
  const float* weight;  // film_weight_row
  const float* depth_m;
  const float* mobility_frac;
  const float* friction_frac;
  const float* head_a;  // curvature_row
  const float* head_b;
  const float* height_a;
  const float* height_b;
};

/// What surface tension, and gravity that pulls paint off the canvas, add to u* on faces between
/// films:
///   u* += dt K (m (head_b - head_a) + (held + hanging) (h_b - h_a)) / dx,  K = friction mobility
///   held += sagging min(1, max(0, d / c - 1)), not taken off again
///   m = min(1, stiffest / (dt^2 K d s L^2)),  held = max(0, m s L - 1 / (dt^2 K d L))
/// The heights are those of the surface that the paint's motion leads to (conservative_scheme.cpp).
/// `held` is a gravity onto the canvas that the height solve adds to the true one (pressure_row),
/// implicitly; here it is taken off again, explicitly. So the force is that of the curvature, and
/// the step is stable: the shortest wave of the grid changes by no more than its height in a step.
/// Thin films need none, and have the exact force. A film deeper than c is more than its surface
/// can carry: it sags like a heap, and spreads along the canvas as under the gravity `sagging`.
/// Scheme: implicit-explicit Euler, 1st order in time, 2nd in space.
/// Stable: any dt, for one wave on a uniform film (conservative_scheme_test.cpp has the others).
/// Source: rate of a ripple, s h^3 q^4 / (3 nu): Orchard, Appl. Sci. Res. A 11 (1962) 451-464; the
///   splitting: Douglas and Dupont, in Numerical Solution of Partial Differential Equations II
///   (1971) 133-214.
/// Departs from it: mobility; stiff paint stands (R12). Deep films have less tension (m), so that a
///   few V-cycles solve the height: on cells of 1 mm in steps of 1/45 s, films deeper than 4 mm.
void capillary_force_row(const CapillaryForce& p, const CapillaryFaces& f, int n,
                         float* velocity_m_s, float* held_m_s2);

}  // namespace pentimento::conservative

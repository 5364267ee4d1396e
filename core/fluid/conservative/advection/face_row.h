#pragma once
// Faces: what a face takes from the paint on its two sides.

namespace pentimento::conservative {

/// A row of cells on one side of the faces.
struct CellRow {
  const float* depth_m;
  const float* base_m;
  const float* height_m;
  const float* mobility_frac;
  const float* viscosity_m2_s;
};

/// A row of faces to fill.
struct FaceRow {
  float* depth_m;
  float* mobility_frac;
  float* viscosity_m2_s;
  float* friction_frac;
};

struct FaceParameters {
  float dry_film_m = 0;            // thinner films feel no gravity (R15)
  float viscosity_floor_m2_s = 0;  // Model::friction_viscosity_floor_m2_s
  float friction_dt_s = 0;         // 3 dt Model::bed_friction
};

/// Finds depth, mobility, viscosity and friction of the faces between the cells a and b.
///   d_f = max(0, max(h_a, h_b) - max(b_a, b_b)); mobility, nu: means weighted by the cells' depth;
///   friction = 1 / (1 + 3 nu dt / d_f^2)
/// Scheme: hydrostatic reconstruction; friction implicit, 1st order, exact at its steady state.
/// Stable: any dt.
/// Source: Audusse et al., SIAM J. Sci. Comput. 25 (2004) 2050-2065 (depth); R12, R13, R15; mean
///   velocity of a film on a no-slip bed, u = g d^2 / (3 nu): Batchelor, Introduction to Fluid
///   Dynamics, 1967, sec. 4.2.
/// Departs from it: nu is at least the floor, for the paper's 1e-6 m^2/s empties a canvas in
///   seconds; bed friction is not in the paper's equation 4.
void face_row(const FaceParameters& p, const CellRow& a, const CellRow& b, int n,
              const FaceRow& out);

/// Marks faces as closed.
void close_faces_row(int n, const FaceRow& out);

}  // namespace pentimento::conservative

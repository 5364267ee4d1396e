#pragma once
// Drag of paint on the paint beside it: how far a force gets on a face whose neighbours are slower
// or faster.

#include "core/base/field.h"

namespace pentimento::conservative {

/// A row of faces of one component, or one of the two rows beside it, across its direction: of
/// right faces those above and below, of lower faces those to the left and right.
struct DragFaces {
  const float* depth_m;  // > 0 wet, 0 dry or closed, < 0 beyond the canvas
  const float* viscosity_m2_s;
  const float* response_frac;  // of the sweep before; of the first: what bed friction leaves
};

/// What is left of a velocity in one step on a bed that drags, f, becomes what is left if the paint
/// beside it drags too: one sweep towards
///   (1/f + c_before + c_after) r = 1 + c_before r_before + c_after r_after
///   c: dt/dx^2 (nu_a + nu_b)/2 between wet faces; beside a dry or closed one, which stands,
///   dt/dx^2 nu; beyond the canvas: slip, 0
/// A uniform film keeps f; what differs from column to column evens out over d / sqrt(3).
/// Scheme: Jacobi, damped by 2/3, which is quickest where columns alternate. Four sweeps have what
///   alternates to a per cent at d = 1.5 dx; what is wider than d is nearly as without.
/// Stable: any dt; 0 < r < the largest f around it.
/// Source: Brinkman, Appl. Sci. Res. A 1 (1949) 27-34: viscosity and the drag of a bed at once.
/// Departs from it: along the flow nothing drags; a few sweeps. All forces are multiplied by the
///   same r, so that forces which cancel still do.
/// `friction_frac`: f, 0 where the face is held. `per_d2`: dt over the square of the cell's side
/// across the direction.
void drag_row(const DragFaces& before, const DragFaces& here, const DragFaces& after,
              const float* friction_frac, float per_d2, int n, float* response_frac);

/// Several sweeps over rows of faces that lie side by side across their direction, as lower faces
/// do: all that a sweep reads lies in the row. The couplings are found once. It gives the same bits
/// as drag_row(), sweep after sweep.
class DragAlongRow {
 public:
  /// `sweeps` >= 2. `friction_frac`: f, which becomes the response. Depth, viscosity and friction
  /// are read one face to each side, where friction is 0.
  void sweep(int sweeps, const float* depth_m, const float* viscosity_m2_s, float per_d2, int n,
             float* friction_frac);

 private:
  Field<float> couplings_;  // rows: before, after, and 1 + f (both)
  Field<float> response_;   // rows: of the sweep before, and of this one; zeros at both ends
};

}  // namespace pentimento::conservative

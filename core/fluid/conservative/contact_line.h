#pragma once
// Contact lines: surface tension at the edge of a film holds the film back from bare canvas.

#include <vector>

#include "core/base/field.h"
#include "core/fluid/conservative/advection/advection.h"

namespace pentimento::conservative {

/// Pins contact lines, on faces between a film and bare canvas.
///   friction *= max(0, 1 - (e / 2 D)^2);  D: mean depth within reach of the face, the nearer the
///   more (1 - r^2 / reach^2), bare cells counting as 0
/// A film of depth d pushes its edge with rho g d^2 / 2 per length. Surface tension pulls the edge
/// back with gamma (1 - cos theta) = rho g e^2 / 2, where e is the depth of a puddle that has come
/// to rest. So an edge stands until its paint is deeper than e. Along a straight edge 2 D = d. A
/// protruding tip has less paint around it and is held more; a notch has more paint and is held
/// less. So the deepest places break out, drain their neighbours, and become drips about as wide as
/// the reach.
/// Scheme: pointwise; a factor on the bed friction, which forces, pressure and momentum share.
/// Stable: a factor in [0, 1] on an implicit friction.
/// Source: de Gennes, Brochard-Wyart, Quere, Capillarity and Wetting Phenomena, 2004, ch. 2.
/// Departs from it: the edge's curvature enters through D alone, and a receding edge is held too.
class ContactLine {
 public:
  /// `depth_m`: e, > 0. `reach_m`: the reach, > 0. `dx_m`, `dy_m`: sides of a cell.
  ContactLine(float depth_m, float reach_m, float dx_m, float dy_m);

  /// Multiplies `friction_frac` of the faces between the cells [x, x + n) of row y and their right
  /// (kX) or lower (kY) neighbours.
  void pin_row(const Field<float>& depth_m, Axis axis, int x, int y, int n,
               float* friction_frac) const;

 private:
  static constexpr int kLanes = 4;  // sums of a mean, a power of 2
  /// One row of the neighbourhood of a face: cells [x0, x1], counted from the cell on the upper or
  /// left side of the face. The weights begin at first(), with zeros before x0 and after x1 that
  /// make them a whole number of lanes.
  struct TapRow {
    int y, x0, x1;
    std::vector<float> weight;
    int first() const { return x0 & -kLanes; }
  };
  struct ProfileTaps {
    std::vector<TapRow> row;
    float total = 0;
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;  // the cells that have a weight, zeros included
    void add(TapRow taps);
  };
  static ProfileTaps taps_around(float from_x, float from_y, float reach_m, float dx_m, float dy_m);
  static float mean_depth(const Field<float>& depth_m, const ProfileTaps& taps, int x, int y);
  static float mean_depth_within(const Field<float>& depth_m, const ProfileTaps& taps, int x,
                                 int y);

  float depth_m_;
  ProfileTaps taps_x_, taps_y_;
};

}  // namespace pentimento::conservative

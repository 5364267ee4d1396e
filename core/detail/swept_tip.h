#pragma once
// The tip as fine cells see it under one stamp: at their resolution, pressed and dried as it is,
// and drawn along the way that the stamp stands for, since fine cells would show each stamp of a
// stroke as a print of its own.

#include <span>

#include "core/brush/stamp_plan.h"
#include "core/field.h"

namespace pentimento {

/// Keeps its map from stamp to stamp.
class SweptTip {
 public:
  /// Draws the map for cells of `cell_m` (the root of their area).
  ///   m(u, v) = mean over n places along the way of the tip at (u, v) + place, the middle the
  ///   stamp's own; n = cells that the way is long, 1 to 8
  /// Scheme: each place is the tip's map moved by parts of a texel, bilinear. Stable: a mean.
  /// Source: ours. Departs from it: a second bilinear step when the map is read, within a texel.
  void draw(const StampPlan& plan, float cell_m);

  /// Values in [0,1] at the cells [first, first + out.size()) of a row; 0 where too faint to touch.
  void row(const TipRow& tip, int first, std::span<float> out) const;

 private:
  void blend(const TipLevel& level);
  void add_print(float u_texels, float v_texels, float weight);

  int size_ = 0;        // of the tip's map
  int margin_ = 0;      // texels around it, the outermost two zero
  Field<float> still_;  // the tip unmoved
  Field<float> map_;
};

}  // namespace pentimento

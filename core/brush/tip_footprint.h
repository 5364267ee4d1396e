#pragma once
// The tip as the cells of a canvas see it under one stamp: pressed and dried as it is, and with its
// bristles averaged over a cell's own area, so that a coarse canvas gets in each cell what a fine
// one gets in the same place.

#include <span>

#include "core/base/field.h"
#include "core/brush/stamp_plan.h"

namespace pentimento {

/// Keeps its map from stamp to stamp.
class TipFootprint {
 public:
  /// Draws the map for cells of `cell_m` (the root of their area) that are larger than bristles.
  ///   m = tip * box, a box in the tip's own frame of such a width that with the texels' own area
  ///   and the bilinear reading of the map the variance is that of a cell, cell_m^2 / 12
  /// Scheme: separable; about three texels to a cell. Stable: weights >= 0, their sum is 1.
  /// Source: ours. Departs from it: cells that lie askew in the tip's frame are averaged over a
  /// square that lies straight.
  void draw_cells(const StampPlan& plan, float cell_m);

  /// Draws the map for fine cells, which would show each stamp of a stroke as a print of its own:
  /// drawn along the way that the stamp stands for.
  ///   m(u, v) = mean over n places along the way of the tip at (u, v) + place, the middle the
  ///   stamp's own; n = cells that the way is long, 1 to 8
  /// Scheme: each place is the tip's map moved by parts of a texel, bilinear. Stable: a mean.
  /// Source: ours. Departs from it: a second bilinear step when the map is read, within a texel.
  void draw_swept(const StampPlan& plan, float cell_m);

  /// The cells [begin, end) of [first, last) of a row beyond which all values are 0.
  struct CellSpan {
    int begin = 0, end = 0;
  };
  CellSpan touched_span(const TipRow& tip, int first, int last) const;

  /// Values in [0,1] at the cells [first, first + out.size()) of a row; 0 where too faint to touch.
  void row(const TipRow& tip, int first, std::span<float> out) const;

 private:
  void blend(const TipLevel& level);
  void find_halves(const TipExtent& extent, float u_texels, float v_texels);
  void average(float texels);
  void add_footprint(float u_texels, float v_texels, float weight);

  int size_ = 0;                   // of the tip's map
  int width_ = 0;                  // of what is in use of the maps, with margins
  int margin_ = 0;                 // texels around it, the outermost two zero
  float half_u_ = 0, half_v_ = 0;  // texels from the middle, from which on all is zero
  Field<float> still_;             // the tip unmoved
  Field<float> map_;
};

}  // namespace pentimento

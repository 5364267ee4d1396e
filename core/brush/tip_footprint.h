#pragma once
// The footprint: the tip as the cells of a canvas see it under one stamp. The tip is pressed and
// dry as the stamp has it, and its bristles are averaged over a cell's own area. So a coarse canvas
// gets in each cell what a fine canvas gets in the same place.

#include <span>
#include <vector>

#include "core/base/field.h"
#include "core/brush/stamp_plan.h"
#include "core/canvas/cell_box.h"

namespace pentimento {

/// Keeps the memory of its map from stamp to stamp.
class TipFootprint {
 public:
  /// Draws the map for cells of the size `cell_m` (the root of their area), larger than bristles.
  ///   m = tip * box, a box in the tip's own frame of such a width that with the texels' own area
  ///   and the bilinear reading of the map the variance is that of a cell, cell_m^2 / 12
  /// Scheme: separable; about three texels to a cell. Stable: weights >= 0, their sum is 1.
  /// Source: ours. Departs from it: cells that lie askew in the tip's frame are averaged over a
  /// square that lies straight.
  void draw_cells(const StampPlan& plan, float cell_m);

  /// Draws the map for fine cells. They would show each stamp of a stroke as a print of its own, so
  /// the tip is drawn along the way that the stamp stands for.
  ///   m(u, v) = mean over n places along the way of the tip at (u, v) + place, the middle the
  ///   stamp's own; n = cells that the way is long, 1 to 8
  /// Scheme: each place is the tip's map moved by parts of a texel, bilinear. Stable: a mean.
  /// Source: ours. Departs from it: a second bilinear step when the map is read, within a texel.
  void draw_swept(const StampPlan& plan, float cell_m);

  /// Cells [begin, end) of a row.
  struct CellSpan {
    int begin = 0, end = 0;
  };
  /// Of the cells [first, last) of a row, those outside of which all values are 0.
  CellSpan touched_span(const TipRow& tip, int first, int last) const;

  /// Writes the tip's values, in [0,1], at the cells [first, first + out.size()) of a row. A value
  /// that is too faint to touch becomes 0.
  void row(const TipRow& tip, int first, std::span<float> out) const;

 private:
  void blend(const TipLevel& level);
  void find_reach(const TipExtent& extent, float u_texels, float v_texels);
  void average(float texels);
  void add_footprint(float u_texels, float v_texels, float weight);
  float middle() const {
    return 0.5f * static_cast<float>(size_) - 0.5f + static_cast<float>(margin_);
  }

  int size_ = 0;                   // of the tip's map
  int width_ = 0;                  // of the part of the maps that is in use, with margins
  int margin_ = 0;                 // texels around the tip; the outermost two are zero
  float half_u_ = 0, half_v_ = 0;  // texels from the middle; beyond them all is zero
  CellBox part_;                   // of the maps that counts; its rim is zero
  Field<float> still_;             // the tip unmoved
  Field<float> map_;
  std::vector<float> box_weight_;
};

}  // namespace pentimento

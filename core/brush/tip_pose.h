#pragma once
// Where a stamp lies on the canvas grid: its pose (place, size, turn, lean) and the box of cells
// that it may cover. Pure geometry.

#include "core/brush/brush_settings.h"
#include "core/brush/stamp.h"
#include "core/brush/tip.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

/// The map from the canvas to the tip, and back. Tip coordinates are in diameters from the centre:
/// u along the tip, v across it. The map keeps areas: one tip square covers diameter_m^2 of canvas.
struct TipPose {
  double x_m = 0, y_m = 0;                   // centre
  float diameter_m = 0;                      // with pressure
  float u_x = 0, u_y = 0, v_x = 0, v_y = 0;  // tip per metre of canvas
  float x_u = 0, x_v = 0, y_u = 0, y_v = 0;  // metres of canvas per tip unit
};

/// The pose of a stamp. Pressure shrinks the tip (BrushDefinition::size_at). Twist turns the tip; a
/// brush that follows the direction turns with the heading first. Tilt stretches the tip by 1 +
/// lean/2 along the lean, narrows it across by as much, and moves it by lean/4 diameters to the
/// side that the handle leans to, where the belly of the brush touches. Lean is the sine of the
/// angle from upright. The diameter is at least `smallest_m`.
TipPose pose_of(const Stamp& stamp, const BrushDefinition& brush, float smallest_m);

/// The pose on a grid: a tip finer than the grid can show is drawn as wide as it can.
TipPose pose_on(const CanvasGeometry& grid, const Stamp& stamp, const BrushDefinition& brush);
/// A cell's size, as tips are asked for: the root of its area.
float cell_size_m(const CanvasGeometry& grid);

/// Width, in diameters, of the box in which v varies as it does over a cell: the mean of a function
/// of v over a cell is about its mean over that box.
float cell_width(const TipPose& pose, const CanvasGeometry& grid);

/// The cells [x, x + width) x [y, y + height) that the tip may touch, within the grid.
struct FootprintBox {
  int x = 0, y = 0, width = 0, height = 0;
  bool inside = false;  // the grid's border cut nothing off
  bool empty() const { return width <= 0 || height <= 0; }
};
FootprintBox box_of(const TipPose& pose, const TipExtent& extent, const CanvasGeometry& geometry);

/// Tip coordinates of the cell centres of a row: those of the centre of cell 0, and the step per
/// cell.
struct TipRow {
  float u0 = 0, v0 = 0, du = 0, dv = 0;
  float u(int x) const { return u0 + du * static_cast<float>(x); }
  float v(int x) const { return v0 + dv * static_cast<float>(x); }
};
/// The tip coordinates of row `y` of the grid. Cell 0 is the first cell of the box.
TipRow tip_row(const TipPose& pose, const FootprintBox& box, const CanvasGeometry& geometry, int y);

}  // namespace pentimento

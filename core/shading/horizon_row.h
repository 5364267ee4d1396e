#pragma once
// The horizon search of one row of cells.

#include <array>
#include <span>

#include "core/shading/horizon.h"

namespace pentimento {

/// Rows of heights around the row that is searched, in metres.
struct HeightRows {
  const float* cell;      // of the row's first cell; the border lies around it
  std::ptrdiff_t stride;  // floats to the cell below
  float dx_m, dy_m;       // of a cell
};

/// The share of an even sky that each cell sees, in [0,1].
///   seen = mean over directions d of cos^2 e_d,
///   tan e_d = max(0, max_i (h(p + i) - h(p) - grad h . i) / |i|)   i: the line's cells
/// Scheme: central differences for grad h; each direction's largest rise of a few cells. Stable:
/// each term in [0,1]. Source: Bavoil, Sainz and Dimitrov 2008, horizons of a height field over the
/// tangent plane. Departs from it: lines of whole cells at growing distances, the same for every
/// cell, so that nothing is random and no tile differs.
void sky_seen_row(const HeightRows& rows, const HorizonLines& lines, std::span<float> seen);

/// The share that each cell sees, in [0,1], of a lamp far away in `direction` (viewer's frame, unit
/// length). The lamp is as large as a soft box.
///   seen = clamp(1/2 + (tan elevation - tan e) / (2 size), 0, 1),  tan e = max_i (h(p+i) - h(p)) /
///   |i|
/// Scheme: linear between the two cells beside the line. Stable: clamped.
/// Source: as above. Departs from it: one direction, over the level instead of the tangent plane.
void lamp_seen_row(const HeightRows& rows, const HorizonLines& lines,
                   const std::array<float, 3>& direction, std::span<float> seen);

/// A lamp so near that each cell sees it in another direction, and the place of the row.
struct NearLamp {
  std::array<float, 3> position_m;  // from the canvas's centre; x right, y up, z out
  std::array<float, 2> half_m;      // of the canvas
  int column, row;   // of the row's first cell on the grid: every tile's numbers agree
  float per_relief;  // true height of a metre in HeightRows
};

/// lamp_seen_row() for a near lamp.
void near_lamp_seen_row(const HeightRows& rows, const HorizonLines& lines, const NearLamp& lamp,
                        std::span<float> seen);

}  // namespace pentimento

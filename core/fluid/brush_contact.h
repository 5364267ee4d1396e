#pragma once
// The contact: where the brush touched the canvas during one step, and how it moved. The stamps
// write it for the fluid. All planes are zero outside the rows [row_begin, row_end) and the columns
// [column_begin, column_end). The simulation clears it after each step.

#include <algorithm>

#include "core/base/field.h"

namespace pentimento {

struct BrushContact {
  Field<float> weight;          // [0,1], the largest value of the step's footprints
  Field<float> velocity_x_m_s;  // of the brush, where weight > 0 (the last stamp's)
  Field<float> velocity_y_m_s;  // y down
  // `conservative`: the sum over stamps of alpha ds direction e(r), as the mean over a cell's
  // paint: what a stamp lays has not been pushed by those before it.
  Field<float> push_x_m;
  Field<float> push_y_m;
  int row_begin = 0, row_end = 0;        // touched; empty when equal
  int column_begin = 0, column_end = 0;  // of these rows

  bool empty() const { return row_begin == row_end; }
  /// Columns [x0, x1) of the rows [y0, y1) will be written to. At least one cell, on the canvas.
  void touch(int x0, int x1, int y0, int y1) {
    const bool first = empty();
    row_begin = first ? y0 : std::min(row_begin, y0);
    row_end = std::max(row_end, y1);
    column_begin = first ? x0 : std::min(column_begin, x0);
    column_end = std::max(column_end, x1);
  }
};

BrushContact make_brush_contact(int width, int height);
/// Sets everything back to untouched.
void clear(BrushContact& contact);

/// Gives back the memory of an untouched contact, whose planes are zero.
void give_back(BrushContact& contact);

BrushContact clone(const BrushContact& contact);

}  // namespace pentimento

#pragma once
// The contact: where the brush touched the canvas during one step, and how it moved. The stamps
// write it for the fluid. All planes are zero outside the rows [row_begin, row_end). The simulation
// clears it after each step.

#include <algorithm>

#include "core/base/field.h"

namespace pentimento {

struct BrushContact {
  Field<float> weight;          // [0,1], the largest value of the step's footprints
  Field<float> velocity_x_m_s;  // of the brush, where weight > 0 (the last stamp's)
  Field<float> velocity_y_m_s;  // y down
  Field<float> push_x_m;        // sum over stamps of alpha ds direction e(r): `conservative`
  Field<float> push_y_m;
  int row_begin = 0, row_end = 0;  // rows touched; empty when equal

  bool empty() const { return row_begin == row_end; }
  void touch_rows(int begin, int end) {
    if (begin >= end) return;
    row_begin = empty() ? begin : std::min(row_begin, begin);
    row_end = std::max(row_end, end);
  }
};

BrushContact make_brush_contact(int width, int height);
/// Sets everything back to untouched.
void clear(BrushContact& contact);

BrushContact clone(const BrushContact& contact);

}  // namespace pentimento

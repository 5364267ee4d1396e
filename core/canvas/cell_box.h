#pragma once
// A rectangle of cells of a grid, and the axes of the grid.

namespace pentimento {

/// kX: along rows. kY: along columns.
enum class Axis { kX, kY };

/// Cells [x0, x1) x [y0, y1).
struct CellBox {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

}  // namespace pentimento

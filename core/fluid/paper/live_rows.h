#pragma once
// Live cells: the cells that a step has to compute. These are the cells with paint, velocity or
// brush, and their neighbours. In all other cells depth and velocity are 0 and would stay 0, so
// leaving them out is exact.

#include <vector>

#include "core/base/threads.h"
#include "core/canvas/canvas_state.h"
#include "core/fluid/brush_contact.h"
#include "core/fluid/paper/grid_rows.h"

namespace pentimento::paper {

class LiveRows {
 public:
  /// Finds the live cells from depth, velocity and contact.
  void find(const CanvasState& state, const BrushContact& contact, const Threads& threads);

  bool empty() const { return row_begin_ >= row_end_; }
  /// Cells to compute in row y.
  Columns live(int y) const { return live_[static_cast<std::size_t>(y)]; }
  /// The live cells of row y and the cells next to them, which the kernels read.
  Columns margin(int y) const { return margin_[static_cast<std::size_t>(y)]; }
  /// Rows whose margin is not empty lie in [row_begin, row_end).
  int row_begin() const { return row_begin_; }
  int row_end() const { return row_end_; }
  std::int64_t cells() const;
  /// The columns between the first and the last live cell of all rows.
  Columns box() const;

 private:
  std::vector<Columns> wet_, live_, margin_;
  int row_begin_ = 0, row_end_ = 0;
};

}  // namespace pentimento::paper

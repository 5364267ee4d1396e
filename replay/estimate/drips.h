#pragma once
// Where thin paint will have run to on a tilted canvas: below a patch of it a sheet as wide as the
// patch, and below the sheet single drips. For estimates; nothing is simulated.

#include <functional>

#include "core/canvas/canvas_state.h"
#include "core/canvas/cell_box.h"

namespace pentimento {

/// How long and which way the canvas was tilted.
class TiltedTime {
 public:
  /// From `time_s` on, gravity along the canvas pulls with (x, y) in the grid's frame.
  void tilt(double x_m_s2, double y_m_s2, double time_s);
  /// Counts up to `time_s`.
  void pass(double time_s);
  /// What was counted is forgotten.
  void forget() { sum_x_s_ = sum_y_s_ = 0; }
  /// Seconds of full gravity along the canvas, as a vector in the grid's frame.
  double x_s() const { return sum_x_s_; }
  double y_s() const { return sum_y_s_; }

 private:
  double x_ = 0, y_ = 0;  // of full gravity
  double since_s_ = 0;
  double sum_x_s_ = 0, sum_y_s_ = 0;
};

/// Calls `reach` with a cell of `among` at the lower edge of a patch of thin paint (where `thin` is
/// true) and each cell that its paint gets to: as far below the edge as 0.85 of the patch's height
/// above it, drips 18 mm apart and 4 mm wide three times its height, neither faster than 16 mm/s.
/// As seen in samples/runs and samples/balance-drips.
void for_drips(const CanvasGeometry& grid, const CellBox& among, const TiltedTime& tilted,
               const std::function<bool(int x, int y)>& thin,
               const std::function<void(int from_x, int from_y, int x, int y)>& reach);

}  // namespace pentimento

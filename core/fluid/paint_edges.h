#pragma once
// How far a step carried paint over each face of the grid. A scheme writes it for a listener that
// moves the same paint on a detail canvas. It is a record only and changes nothing of the step.

#include <vector>

#include "core/base/runs.h"
#include "core/canvas/canvas_state.h"

namespace pentimento {

struct PaintEdges {
  PaintEdges() = default;
  PaintEdges(const CanvasGeometry& geometry, int layers) {
    for (int i = 0; i <= layers; ++i) {
      x.emplace_back(geometry.width, geometry.height);
      y.emplace_back(geometry.width, geometry.height);
    }
  }
  // Displacements in cells, of the right (x) and the lower (y) face of each cell: first of the
  // depth, then of each layer. 0 where nothing moved.
  std::vector<Field<float>> x;
  std::vector<Field<float>> y;
  bool x_first = true;
};

struct StepInput;

/// The interface of anything that follows the motion of paint, part of a step by part of a step.
class AdvectionListener {
 public:
  virtual ~AdvectionListener() = default;
  /// Where the scheme writes its edges. They are all 0 when it begins, and moved() sets them back
  /// to 0.
  virtual PaintEdges& edges() = 0;
  /// Called after the scheme has moved the paint of `state` in the cells of `runs`, first along one
  /// axis, then along the other.
  virtual void moved(const CanvasState& state, const StepInput& in,
                     const std::vector<conservative::Run>& runs) = 0;
};

}  // namespace pentimento

#pragma once
// How far the edges between velocity nodes move. An edge lies between two nodes. If x nodes move
// along x, or y nodes along y, the edge is the centre of a cell, between the two faces of that
// cell. If nodes move across their axis, the edge is the corner of a cell, between the two faces
// that meet there, of this column and the next or of this row and the next.

#include "core/canvas/canvas_state.h"
#include "core/fluid/conservative/advection/line_batch.h"
#include "core/fluid/conservative/solve/work_plane.h"

namespace pentimento::conservative {

class MomentumEdges {
 public:
  /// Nodes move along `axis`, for a time of `dt_s`. `mass_m`: the paint around the nodes that move
  /// along their own axis.
  MomentumEdges(const CanvasState& state, float dt_s, Axis axis, const WorkPlane& mass_m);
  /// Fills the displacements of the edges of a batch, in cells, b.cells() + b.step() of them: for
  /// the nodes of the component along `axis`, or (`along` false) of the other one.
  void fill(const LineBatch& b, bool along, float* edge) const;

 private:
  const Field<float>& velocity_m_s_;
  const WorkPlane& mass_m_;
  Axis axis_;
  float to_cells_;
};

}  // namespace pentimento::conservative

#include "core/fluid/conservative/advection/momentum_edges.h"

#include <algorithm>

#include "core/base/kernel.h"

namespace pentimento::conservative {
namespace {

// A row of faces: their velocity and the paint around them.
struct FaceFlow {
  const float* velocity;
  const float* mass;
};

// Displacement of an edge between two faces: the mean of their velocities weighted by mass, so that
// a front beside bare canvas moves as fast as its paint.
PENTIMENTO_KERNEL
void mean_row(const FaceFlow& a, const FaceFlow& b, float to_cells, int n, float* __restrict edge) {
  const float* __restrict mass_a = a.mass;
  const float* __restrict mass_b = b.mass;
  const float* __restrict u_a = a.velocity;
  const float* __restrict u_b = b.velocity;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float mass = mass_a[i] + mass_b[i];
    const float momentum = mass_a[i] * u_a[i] + mass_b[i] * u_b[i];
    edge[i] = mass > 0 ? to_cells * (momentum / (mass > 0 ? mass : 1.0f)) : 0.0f;
  }
}

// How far the second face of an edge is from the first.
struct Offset {
  int x = 0, y = 0;
};
void fill_edges(const LineBatch& b, float to_cells, const Field<float>& velocity,
                const WorkPlane& mass, Offset other, float* edge) {
  const int last_x = velocity.width() - 1;
  const int last_y = velocity.height() - 1;
  for_inner_edges(b, [&](int first, int n, int x, int y) {
    const int y2 = std::min(y + other.y, last_y);
    const int inner = std::min(n, last_x + 1 - x - other.x);  // the last column has no next one
    const auto at = [&](int i, int j) { return FaceFlow{velocity.row(j) + i, mass.row(j) + i}; };
    mean_row(at(x, y), at(x + other.x, y2), to_cells, inner, edge + first);
    if (inner < n) mean_row(at(last_x, y), at(last_x, y2), to_cells, 1, edge + first + n - 1);
  });
}

}  // namespace

MomentumEdges::MomentumEdges(const CanvasState& state, float dt_s, Axis axis,
                             const WorkPlane& mass_m)
    : velocity_m_s_(axis == Axis::kX ? state.velocity_x_m_s : state.velocity_y_m_s),
      mass_m_(mass_m),
      axis_(axis),
      to_cells_(dt_s / (axis == Axis::kX ? state.geometry.dx_m() : state.geometry.dy_m())) {}

void MomentumEdges::fill(const LineBatch& b, bool along, float* edge) const {
  const bool next_column = (axis_ == Axis::kX) == along;
  // The ends are walls.
  std::fill_n(edge, b.step(), 0.0f);
  std::fill_n(edge + b.cells(), b.step(), 0.0f);
  fill_edges(b, to_cells_, velocity_m_s_, mass_m_, next_column ? Offset{1, 0} : Offset{0, 1}, edge);
}

}  // namespace pentimento::conservative

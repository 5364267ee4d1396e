#include <algorithm>

#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/line_batch.h"
#include "core/fluid/conservative/advection/paint_rows.h"
#include "core/fluid/conservative/advection/remap_momentum.h"
#include "core/fluid/conservative/advection/remap_stream.h"

namespace pentimento::conservative {
namespace {

// The paint around the nodes between two rows of cells, or between cells of a row.
PENTIMENTO_KERNEL
void node_mass_row(const float* __restrict depth_a, const float* __restrict depth_b, int n,
                   float* __restrict mass) {
  for (int i = 0; i < n; ++i) mass[i] = 0.5f * (depth_a[i] + depth_b[i]);
}

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

// An edge lies between two nodes. If x nodes move along x, or y nodes along y, the edge is the
// centre of a cell, between the two faces of that cell. If nodes move across their axis, the edge
// is the corner of a cell, between the two faces that meet there, of this column and the next or of
// this row and the next.
// `other`: how far the second face is from the first.
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

// Displacements of the edges of a batch for the nodes of both components.
struct MomentumEdges {
  const CanvasState& state;
  float to_cells;
  Axis axis;
  const WorkPlane& mass;  // of the nodes that move along their own axis

  // `along`: whether the nodes belong to the component of `axis`; else they belong to the other
  // one.
  void fill(const LineBatch& b, bool along, std::vector<float>& edge) const {
    const bool next_column = (axis == Axis::kX) == along;
    const Field<float>& u = axis == Axis::kX ? state.velocity_x_m_s : state.velocity_y_m_s;
    std::fill(edge.begin(), edge.end(), 0.0f);
    fill_edges(b, to_cells, u, mass, next_column ? Offset{1, 0} : Offset{0, 1}, edge.data());
  }
};

// Nodes of one component, and their velocities in the state.
struct Nodes {
  NodePlanes& planes;
  const Field<float>& state_m_s;
};
Nodes nodes_x(const CanvasState& state, Workspace& work) {
  return {work.x, state.velocity_x_m_s};
}
Nodes nodes_y(const CanvasState& state, Workspace& work) {
  return {work.y, state.velocity_y_m_s};
}

// Moves a batch as flat arrays.
struct BatchMover {
  RemapPlan plan;
  RemapScratch scratch;

  void move(const LineBatch& b, const RemapOptions& options, Turn turn, const Nodes& moved) {
    NodePlanes& nodes = moved.planes;
    // Plan where each node's fluid goes, ...
    plan_remap(plan);
    float* mass = scratch.cells(scratch.value, plan.step);
    float* velocity = scratch.cells(scratch.momentum, plan.step);
    // ... take mass and velocity from before this turn, ...
    if (turn == Turn::kFirst) {
      load_batch(b, nodes.first_mass_m, mass);
      load_batch(b, moved.state_m_s, velocity);
    } else {
      load_batch(b, nodes.mass_m, mass);
      load_batch(b, nodes.velocity_m_s, velocity);
    }
    // ... and move both.
    remap_momentum_batch(plan, options, scratch);
    store_batch(b, mass, nodes.mass_m);
    store_batch(b, velocity, nodes.velocity_m_s);
  }
};

// Moves a batch of columns along y, row by row. The first turn reads the state and
// fill_node_masses(); the second turn works in place.
struct RowMover {
  std::vector<float> edge;
  EdgeStream edges;
  MomentumStream stream;
  int n = 0;

  void resize(const LineBatch& b) {
    edge.resize(static_cast<std::size_t>(b.cells() + b.width()));
    if (b.width() == n) return;
    n = b.width();
    edges.resize(n);
    stream.resize(n);
  }

  void move(const LineBatch& b, const RemapOptions& options, Turn turn, const Nodes& moved) {
    NodePlanes& nodes = moved.planes;
    const bool first = turn == Turn::kFirst;
    constexpr float kNear = 0.49f;  // edges that move no further leave no cell shorter than 1/64
    const int height = b.height();
    const auto edge_row = [&](int r) { return edge.data() + r * n; };
    const auto row_of = [&](WorkPlane& plane, int r) { return plane.row(b.box.y0 + r) + b.box.x0; };
    const auto mass_before = [&](int r) {
      return row_of(first ? nodes.first_mass_m : nodes.mass_m, r);
    };
    const auto velocity_before = [&](int r) {
      return first ? moved.state_m_s.row(b.box.y0 + r) + b.box.x0 : row_of(nodes.velocity_m_s, r);
    };
    const auto rows_of = [&](const auto& row, int r) {
      return ThreeRows{row(std::max(r - 1, 0)), row(r), row(std::min(r + 1, height - 1))};
    };
    const bool all_near = !any_beyond_row(edge.data(), kNear, static_cast<int>(edge.size()));
    // Row r's fluxes need rows r - 1 to r + 1 as they were, so row r - 1 is written once they are
    // done.
    stream.begin();
    for (int r = 0; r <= height; ++r) {
      if (r < height) {
        const bool moves = any_motion_row(edge_row(r), 2 * n);
        edges.plan(r, edge_row(r), edge_row(r + 1), moves);
        stream.flux(edges, options, r, rows_of(mass_before, r), rows_of(velocity_before, r));
      } else {
        stream.end(r);
      }
      if (r == 0) continue;
      // The first turn must leave its input as it is: row r - 1 is copied before it changes.
      if (first) {
        std::copy_n(mass_before(r - 1), n, row_of(nodes.mass_m, r - 1));
        std::copy_n(velocity_before(r - 1), n, row_of(nodes.velocity_m_s, r - 1));
      }
      stream.gather(edges, r - 1, row_of(nodes.mass_m, r - 1), row_of(nodes.velocity_m_s, r - 1),
                    all_near);
    }
    // Fluid that moves further than to the next node is added last; momentum then becomes velocity.
    if (all_near) return;
    const auto target = [&](WorkPlane& plane) {
      return [&plane, &b](int r, int lane) -> float& {
        return plane.row(b.box.y0 + r)[b.box.x0 + lane];
      };
    };
    put_far_momentum(stream.far(), stream.far_speed(), {height, b.box.y0}, target(nodes.mass_m),
                     target(nodes.velocity_m_s));
    for (int r = 0; r < height; ++r)
      velocity_row(row_of(nodes.mass_m, r), row_of(nodes.velocity_m_s, r), n);
  }
};

}  // namespace

void fill_node_masses(const CanvasState& state, const WetCells& wet, const Threads& threads,
                      Workspace& work) {
  const int width = state.geometry.width;
  const int height = state.geometry.height;
  for_runs(threads, wet.runs(), [&](const Run& r) {
    const float* d = state.depth_m.row(r.y);
    const float* below = state.depth_m.row(std::min(r.y + 1, height - 1));
    float* mx = work.x.first_mass_m.row(r.y);
    float* my = work.y.first_mass_m.row(r.y);
    const int inner = std::min(r.x1, width - 1) - r.x0;
    node_mass_row(d + r.x0, d + r.x0 + 1, inner, mx + r.x0);
    if (r.x1 == width) mx[width - 1] = 0.5f * d[width - 1];
    node_mass_row(d + r.x0, below + r.x0, r.size(), my + r.x0);
  });
}

void advect_momentum_in_batches(const CanvasState& state, const StepInput& in, Axis axis, Turn turn,
                                const WetCells& wet, Workspace& work) {
  const RemapOptions options{in.model.superbee, 0};
  const float cell_m = axis == Axis::kX ? state.geometry.dx_m() : state.geometry.dy_m();
  const Nodes along = axis == Axis::kX ? nodes_x(state, work) : nodes_y(state, work);
  const Nodes across = axis == Axis::kX ? nodes_y(state, work) : nodes_x(state, work);
  const MomentumEdges edges{state, in.dt_s / cell_m, axis, along.planes.first_mass_m};
  for_batches(wet, axis, in.threads, [&](int begin, int end, const auto& block_at) {
    BatchMover mover;
    for (int k = begin; k < end; ++k) {
      const LineBatch b = block_at(k);
      mover.plan.resize(b.cells(), b.step());
      mover.scratch.resize(b.cells(), b.step());
      mover.plan.before = axis == Axis::kX ? b.box.x0 : b.box.y0;
      edges.fill(b, true, mover.plan.edge);
      mover.move(b, options, turn, along);
      edges.fill(b, false, mover.plan.edge);
      mover.move(b, options, turn, across);
    }
  });
}

void advect_momentum(const CanvasState& state, const StepInput& in, Axis axis, Turn turn,
                     const WetCells& wet, Workspace& work) {
  if (axis == Axis::kX) return advect_momentum_in_batches(state, in, axis, turn, wet, work);
  const RemapOptions options{in.model.superbee, 0};
  const MomentumEdges edges{state, in.dt_s / state.geometry.dy_m(), axis, work.y.first_mass_m};
  for_wide_batches(wet, in.threads, [&](int begin, int end, const auto& block_at) {
    RowMover mover;
    for (int k = begin; k < end; ++k) {
      const LineBatch b = block_at(k);
      mover.resize(b);
      edges.fill(b, true, mover.edge);
      mover.move(b, options, turn, nodes_y(state, work));
      edges.fill(b, false, mover.edge);
      mover.move(b, options, turn, nodes_x(state, work));
    }
  });
}

}  // namespace pentimento::conservative

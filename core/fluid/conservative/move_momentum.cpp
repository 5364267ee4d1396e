#include <algorithm>

#include "core/fluid/conservative/block.h"
#include "core/fluid/conservative/remap_momentum.h"
#include "core/fluid/conservative/transport.h"

namespace pentimento::conservative {
namespace {

// Edges of x nodes moving along x, and of y nodes along y, are cell centres: the mean of the two
// faces of that cell. Inner edge e lies in the cell of node e.
template <typename Row>
void edges_at_centres(const Block& b, float to_cells, const Row& velocity_row, float* edge) {
  const int back_y = b.axis == Axis::kY ? 1 : 0;
  for_inner_edges(b, [&](int first, int n, int x, int y) {
    const float* before = velocity_row(y) + x;
    const float* after = back_y ? velocity_row(y + 1) + x : before + 1;
    for (int i = 0; i < n; ++i) edge[first + i] = 0.5f * to_cells * (before[i] + after[i]);
  });
}

// Edges of nodes moving along the other axis are corners of cells: the mean of the two faces that
// meet there, `beside` being the next column (x nodes) or the next row (y nodes).
void edges_at_corners(const Block& b, float to_cells, const Field<float>& velocity, float* edge) {
  const int last_x = velocity.width() - 1;
  const int last_y = velocity.height() - 1;
  for_inner_edges(b, [&](int first, int n, int x, int y) {
    const float* here = velocity.row(y);
    if (b.axis == Axis::kY) {
      for (int i = 0; i < n; ++i)
        edge[first + i] = 0.5f * to_cells * (here[x + i] + here[std::min(x + i + 1, last_x)]);
    } else {
      const float* beside = velocity.row(std::min(y + 1, last_y));
      for (int i = 0; i < n; ++i) edge[first + i] = 0.5f * to_cells * (here[x + i] + beside[x + i]);
    }
  });
}

struct Mover {
  RemapPlan plan;
  RemapScratch scratch;

  void move(const Block& b, const RemapOptions& options, NodePlanes& nodes) {
    plan_remap(plan);
    load_block(b, nodes.mass_m, scratch.cells(scratch.value, plan.step));
    load_block(b, nodes.velocity_m_s, scratch.cells(scratch.momentum, plan.step));
    remap_momentum_block(plan, options, scratch);
    store_block(b, scratch.cells(scratch.value, plan.step), nodes.mass_m);
    store_block(b, scratch.cells(scratch.momentum, plan.step), nodes.velocity_m_s);
  }
};

}  // namespace

void fill_node_masses(const CanvasState& state, const Tiles& tiles, const Threads& threads,
                      Workspace& work) {
  const int width = state.geometry.width;
  const int height = state.geometry.height;
  for_runs(threads, tiles.runs(), [&](const Run& r) {
    const float* d = state.depth_m.row(r.y);
    const float* below = state.depth_m.row(std::min(r.y + 1, height - 1));
    float* mx = work.x.mass_m.row(r.y);
    float* my = work.y.mass_m.row(r.y);
    const int inner = std::min(r.x1, width - 1);
    for (int x = r.x0; x < inner; ++x) mx[x] = 0.5f * (d[x] + d[x + 1]);
    if (r.x1 == width) mx[width - 1] = 0.5f * d[width - 1];
    for (int x = r.x0; x < r.x1; ++x) my[x] = 0.5f * (d[x] + below[x]);
  });
}

void fill_node_velocities(const CanvasState& state, const Tiles& tiles, const Threads& threads,
                          Workspace& work) {
  for_runs(threads, tiles.runs(), [&](const Run& r) {
    std::copy_n(state.velocity_x_m_s.row(r.y) + r.x0, r.size(),
                work.x.velocity_m_s.row(r.y) + r.x0);
    std::copy_n(state.velocity_y_m_s.row(r.y) + r.x0, r.size(),
                work.y.velocity_m_s.row(r.y) + r.x0);
  });
}

void move_momentum(const CanvasState& state, const StepInput& in, Axis axis, const Tiles& tiles,
                   Workspace& work) {
  const RemapOptions options{in.model.superbee, 0};
  const Field<float>& u = axis == Axis::kX ? state.velocity_x_m_s : state.velocity_y_m_s;
  const float to_cells =
      in.dt_s / (axis == Axis::kX ? state.geometry.dx_m() : state.geometry.dy_m());
  NodePlanes& along = axis == Axis::kX ? work.x : work.y;
  NodePlanes& across = axis == Axis::kX ? work.y : work.x;
  for_blocks(tiles, axis, in.threads, [&](int begin, int end, const auto& block_at) {
    Mover mover;
    for (int k = begin; k < end; ++k) {
      const Block b = block_at(k);
      mover.plan.resize(b.cells(), b.step());
      mover.scratch.resize(b.cells(), b.step());
      std::fill(mover.plan.edge.begin(), mover.plan.edge.end(), 0.0f);
      edges_at_centres(
          b, to_cells, [&](int y) { return u.row(y); }, mover.plan.edge.data());
      mover.move(b, options, along);
      edges_at_corners(b, to_cells, u, mover.plan.edge.data());
      mover.move(b, options, across);
    }
  });
}

}  // namespace pentimento::conservative

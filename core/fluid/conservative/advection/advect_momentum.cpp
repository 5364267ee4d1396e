#include <algorithm>

#include "core/base/fetch_ahead.h"
#include "core/base/kernel.h"
#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/line_batch.h"
#include "core/fluid/conservative/advection/momentum_edges.h"
#include "core/fluid/conservative/advection/momentum_stream.h"
#include "core/fluid/conservative/advection/paint_rows.h"

namespace pentimento::conservative {
namespace {

// The paint around the nodes between two rows of cells, or between cells of a row.
PENTIMENTO_KERNEL
void node_mass_row(const float* __restrict depth_a, const float* __restrict depth_b, int n,
                   float* __restrict mass) {
  for (int i = 0; i < n; ++i) mass[i] = 0.5f * (depth_a[i] + depth_b[i]);
}

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

// Moves a run of nodes along x. The buffers are kept from run to run; a row of nodes in them has
// one node more at each end.
class MomentumRow {
 public:
  MomentumRow(const RemapOptions& options, Turn turn) : options_(options), turn_(turn) {}

  void move(const Run& r, const MomentumEdges& edges, bool along, const Nodes& moved) {
    resize(r);
    for (const WorkPlane* p : {&moved.planes.mass_m, &moved.planes.velocity_m_s})
      fetch_row_ahead(*p, r.y, r.x0, r.x1);
    float* edge = nodes(edge_);
    edges.fill({{r.x0, r.x1, r.y, r.y + 1}, Axis::kX}, along, edge);
    // Mass and velocity from before this turn, ...
    NodePlanes& planes = moved.planes;
    const bool first = turn_ == Turn::kFirst;
    const float* mass = load(first ? planes.first_mass_m.row(r.y) : planes.mass_m.row(r.y), mass_);
    const float* velocity =
        load(first ? moved.state_m_s.row(r.y) : planes.velocity_m_s.row(r.y), velocity_);
    // ... what leaves each node, ...
    float* mass_lo = nodes(mass_lo_);
    float* mass_hi = nodes(mass_hi_);
    float* momentum_lo = nodes(momentum_lo_);
    float* momentum_hi = nodes(momentum_hi_);
    float* stay = nodes(stay_);
    const ThreeRows masses{mass - 1, mass, mass + 1};
    const int far = leave_momentum_rows(options_.superbee, {edge, edge + 1}, masses,
                                        {velocity - 1, velocity, velocity + 1}, r.size(),
                                        {mass_lo, mass_hi, momentum_lo, momentum_hi, stay});
    // ... and what it becomes.
    const auto settle = far > 0 ? settle_momentum_rows : settle_velocity_rows;
    const NodesAfter after{planes.mass_m.row(r.y) + r.x0, planes.velocity_m_s.row(r.y) + r.x0};
    settle(stay, {mass_hi - 1, mass_hi, mass_lo, mass_lo + 1},
           {momentum_hi - 1, momentum_hi, momentum_lo, momentum_lo + 1}, {mass, velocity}, r.size(),
           after);
    if (far > 0) add_far(masses, velocity, after);
  }

 private:
  static constexpr int kSide = 16;  // one cache line of floats
  static float* nodes(Field<float>& row) { return row.row(0) + kSide; }

  void resize(const Run& r) {
    r_ = r;
    const int n = r.size();
    if (n + 2 * kSide > edge_.width())
      for (Field<float>* f :
           {&edge_, &mass_, &velocity_, &mass_lo_, &mass_hi_, &momentum_lo_, &momentum_hi_, &stay_})
        *f = Field<float>(n + 2 * kSide, 1);
    // Nothing comes through the walls.
    nodes(mass_hi_)[-1] = nodes(momentum_hi_)[-1] = 0;
    nodes(mass_lo_)[n] = nodes(momentum_lo_)[n] = 0;
  }
  // A copy of the run with its ends mirrored.
  const float* load(const float* row, Field<float>& to) const {
    float* copy = nodes(to);
    std::copy_n(row + r_.x0, r_.size(), copy);
    mirror_ends(copy, r_.size());
    return copy;
  }
  // Fluid that moves further than to the next node is added last; momentum then becomes velocity.
  void add_far(const ThreeRows& mass, const float* velocity, const NodesAfter& after) {
    const float* stay = nodes(stay_);
    far_.clear();
    for (int i = 0; i < r_.size(); ++i)
      if (stay[i] == 0) far_.push_back(i);
    const std::vector<FarCell> cells = take_far_cells(far_, nodes(edge_), options_, mass);
    std::vector<float> speed;
    for (const FarCell& cell : cells) speed.push_back(velocity[cell.at]);
    put_far_momentum(
        cells, speed, {r_.size(), r_.x0}, [&](int i, int) -> float& { return after.mass[i]; },
        [&](int i, int) -> float& { return after.velocity[i]; });
    velocity_row(after.mass, after.velocity, r_.size());
  }

  RemapOptions options_;
  Turn turn_;
  Run r_;
  Field<float> edge_, mass_, velocity_, mass_lo_, mass_hi_, momentum_lo_, momentum_hi_, stay_;
  std::vector<int> far_;
};

// Moves a batch of columns along y, row by row. The first turn reads the state and
// fill_node_masses(); the second turn works in place.
class MomentumColumns {
 public:
  MomentumColumns(const RemapOptions& options, Turn turn) : options_(options), turn_(turn) {}

  void move(const LineBatch& b, const MomentumEdges& edges, bool along, const Nodes& moved) {
    resize(b);
    edges.fill(b, along, edge_.data());
    NodePlanes& nodes = moved.planes;
    const bool first = turn_ == Turn::kFirst;
    constexpr float kNear = 0.49f;  // edges that move no further leave no cell shorter than 1/64
    const int n = b.width();
    const int height = b.height();
    const auto edge_row = [&](int r) { return edge_.data() + r * n; };
    const auto row_of = [&](WorkPlane& plane, int r) { return plane.row(b.box.y0 + r) + b.box.x0; };
    const auto before = [&](int r) {
      return first ? NodesBefore{row_of(nodes.first_mass_m, r),
                                 moved.state_m_s.row(b.box.y0 + r) + b.box.x0}
                   : NodesBefore{row_of(nodes.mass_m, r), row_of(nodes.velocity_m_s, r)};
    };
    const bool all_near = !any_beyond_row(edge_.data(), kNear, b.cells() + n);
    // What leaves row r depends on rows r - 1 to r + 1 as they were, so row r - 1 is written once
    // that is known.
    stream_.begin();
    for (int r = 0; r <= height; ++r) {
      if (r < height) {
        const NodesBefore above = before(std::max(r - 1, 0));
        const NodesBefore here = before(r);
        const NodesBefore below = before(std::min(r + 1, height - 1));
        stream_.leave(
            options_, r, {edge_row(r), edge_row(r + 1)}, any_motion_row(edge_row(r), 2 * n),
            {{above.mass, here.mass, below.mass}, {above.velocity, here.velocity, below.velocity}});
      } else {
        stream_.end(r);
      }
      if (r > 0)
        stream_.settle(r - 1, before(r - 1), all_near,
                       {row_of(nodes.mass_m, r - 1), row_of(nodes.velocity_m_s, r - 1)});
    }
    // Fluid that moves further than to the next node is added last; momentum then becomes velocity.
    if (all_near) return;
    const auto target = [&](WorkPlane& plane) {
      return [&plane, &b](int r, int lane) -> float& {
        return plane.row(b.box.y0 + r)[b.box.x0 + lane];
      };
    };
    put_far_momentum(stream_.far(), stream_.far_speed(), {height, b.box.y0}, target(nodes.mass_m),
                     target(nodes.velocity_m_s));
    for (int r = 0; r < height; ++r)
      velocity_row(row_of(nodes.mass_m, r), row_of(nodes.velocity_m_s, r), n);
  }

 private:
  void resize(const LineBatch& b) {
    const auto edges = static_cast<std::size_t>(b.cells() + b.width());
    if (edge_.size() < edges) edge_.resize(edges);
    stream_.resize(b.width());
  }

  RemapOptions options_;
  Turn turn_;
  std::vector<float> edge_;
  MomentumStream stream_;
};

}  // namespace

void fill_node_masses(const CanvasState& state, const WetCells& wet, const Threads& threads,
                      Workspace& work) {
  const int width = state.geometry.width;
  const int height = state.geometry.height;
  for_runs(threads, wet.runs(), [&](const Run& r) {
    for (const WorkPlane* p : {&work.x.first_mass_m, &work.y.first_mass_m})
      fetch_row_ahead(*p, r.y, r.x0, r.x1);
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

void advect_momentum(const CanvasState& state, const StepInput& in, Axis axis, Turn turn,
                     const WetCells& wet, Workspace& work) {
  const RemapOptions options{in.model.superbee, 0};
  const Nodes along = axis == Axis::kX ? nodes_x(state, work) : nodes_y(state, work);
  const Nodes across = axis == Axis::kX ? nodes_y(state, work) : nodes_x(state, work);
  const MomentumEdges edges(state, in.dt_s, axis, along.planes.first_mass_m);
  if (axis == Axis::kX) {
    const std::vector<Run>& runs = wet.runs();
    in.threads.for_ranges(0, static_cast<int>(runs.size()), 8, [&](int begin, int end) {
      MomentumRow row(options, turn);
      for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
        row.move(runs[k], edges, true, along);
        row.move(runs[k], edges, false, across);
      }
    });
  } else {
    for_wide_batches(wet, in.threads, [&](int begin, int end, const auto& block_at) {
      MomentumColumns columns(options, turn);
      for (int k = begin; k < end; ++k) {
        columns.move(block_at(k), edges, true, along);
        columns.move(block_at(k), edges, false, across);
      }
    });
  }
}

}  // namespace pentimento::conservative

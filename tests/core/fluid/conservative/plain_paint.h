#pragma once
// The plain twin of moving paint: batch after batch, each quantity copied into a flat array, moved
// there by remap_batch and copied back. Any axis.

#include <algorithm>

#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/crowd_limit.h"
#include "core/fluid/conservative/advection/layer_speed_row.h"
#include "core/fluid/conservative/tiles/quantum.h"
#include "tests/core/fluid/conservative/plain_batches.h"
#include "tests/core/fluid/conservative/plain_remap.h"

namespace pentimento::conservative {
// Everything one thread needs to move the paint of a batch; buffers are kept between batches.
class PlainPaintMover {
 public:
  PlainPaintMover(CanvasState& state, const StepInput& in, Axis axis)
      : state_(state), in_(in), axis_(axis) {
    amount_.superbee = depth_.superbee = in.model.superbee;
    depth_.rounder = rounder_for(quantum_for(in.model.max_medium_m));
    amount_.rounder = rounder_for(quantum_for(in.model.max_pigment));
  }

  void move(const LineBatch& b) {
    const auto n = static_cast<std::size_t>(b.cells());
    plan_.resize(b.cells(), b.step());
    scratch_.resize(b.cells(), b.step());
    for (std::vector<float>* v : {&flow_, &push_}) v->assign(plan_.edge.size(), 0);
    for (std::vector<float>* v : {&total_, &share_, &held_}) v->assign(n, 0);
    layer_.assign(at(state_.layers), std::vector<float>(n, 0));
    middle_ = layer_;
    present_.resize(state_.pigment.size());
    fill_displacements(b);
    find_layers(b);
    move_depth(b);
    for (int layer = 0; layer < state_.layers; ++layer) move_layer(b, layer);
  }

 private:
  void fill_displacements(const LineBatch& b) {
    const bool along_x = axis_ == Axis::kX;
    const CanvasGeometry& g = state_.geometry;
    const float per_m = 1 / (along_x ? g.dx_m() : g.dy_m());
    const Field<float>& velocity = along_x ? state_.velocity_x_m_s : state_.velocity_y_m_s;
    const Field<float>& push = along_x ? in_.contact.push_x_m : in_.contact.push_y_m;
    const int next_row = along_x ? 0 : 1;
    const int next_column = along_x ? 1 : 0;
    for_inner_edges(b, [&](int first, int n, int x, int y) {
      const float* u = velocity.row(y) + x;
      for (int i = 0; i < n; ++i) flow_[at(first + i)] = u[i] * in_.dt_s * per_m;
      if (y + next_row < in_.contact.row_begin || y >= in_.contact.row_end) return;
      const float* here = push.row(y) + x;
      const float* next = push.row(y + next_row) + x + next_column;
      for (int i = 0; i < n; ++i) push_[at(first + i)] = 0.5f * (here[i] + next[i]) * per_m;
    });
  }

  // present_ = the channels that are in the block at all; share_ = the share of layer 0 that moves;
  // middle_ = where in the film each layer lies, by the pigment that moves.
  void find_layers(const LineBatch& b) {
    for (int layer = 0; layer < state_.layers; ++layer) {
      std::vector<float>& sum = layer_[at(layer)];
      for (int c = 0; c < state_.channels; ++c) {
        load_batch(b, state_.channel(layer, c), held_.data());
        present_[at(layer * state_.channels + c)] =
            std::any_of(held_.begin(), held_.end(), [](float a) { return a > 0; });
        for (std::size_t i = 0; i < held_.size(); ++i) sum[i] += in_.amount[at(c)] * held_[i];
      }
      for (std::size_t i = 0; i < sum.size(); ++i) {
        const float free = std::max(sum[i] - in_.model.pigment_residue, 0.0f);
        if (layer == 0) share_[i] = free / (free > 0 ? sum[i] : 1.0f);
        if (layer == 0) sum[i] = free;
        total_[i] += sum[i];
      }
    }
    for (std::size_t i = 0; i < total_.size(); ++i) {
      float below = 0;
      for (std::size_t k = 0; k < layer_.size(); ++k) {
        if (layer_[k][i] > 0) middle_[k][i] = (below + 0.5f * layer_[k][i]) / total_[i];
        below += layer_[k][i];
      }
    }
  }

  void move_depth(const LineBatch& b) {
    for (std::size_t e = 0; e < plan_.edge.size(); ++e)
      plan_.edge[e] = flow_[e] + 0.5f * push_[e];  // (k + 1/2)/n is 1/2 in the mean over layers
    float* value = scratch_.cells(scratch_.value, plan_.step);
    load_batch(b, state_.depth_m, value);
    mirror_batch(value, b.cells(), plan_.step);
    const CrowdLines lines{b.cells() / plan_.step, plan_.step,
                           kMostDepthShare * in_.model.max_medium_m};
    if (limit_crowding(lines, value, plan_.edge.data()))
      for (std::size_t e = 0; e < plan_.edge.size(); ++e)
        flow_[e] = plan_.edge[e] - 0.5f * push_[e];  // the layers give way with it
    record(b, 0);
    plan_remap(plan_);
    remap_batch(plan_, depth_, scratch_);
    store_batch(b, value, state_.depth_m);
  }

  void move_layer(const LineBatch& b, int layer) {
    const std::size_t s = static_cast<std::size_t>(plan_.step);
    const std::size_t inner = plan_.edge.size() - 2 * s;
    const float* middle = middle_[at(layer)].data();
    layer_speed_row(in_.model.layer_speed, middle, middle + s, flow_.data() + s, push_.data() + s,
                    static_cast<int>(inner), plan_.edge.data() + s);
    record(b, 1 + layer);
    plan_remap(plan_);
    float* value = scratch_.cells(scratch_.value, plan_.step);
    for (int c = 0; c < state_.channels; ++c) {
      if (!present_[at(layer * state_.channels + c)]) continue;
      Field<float>& plane = state_.channel(layer, c);
      load_batch(b, plane, value);
      if (layer == 0) split_residue(value);
      remap_batch(plan_, amount_, scratch_);
      if (layer == 0)
        for (std::size_t i = 0; i < held_.size(); ++i) value[i] += held_[i];
      store_batch(b, value, plane);
    }
  }

  void split_residue(float* value) {
    for (std::size_t i = 0; i < held_.size(); ++i) {
      const float free = std::min(rounded(value[i] * share_[i], amount_.rounder), value[i]);
      held_[i] = value[i] - free;
      value[i] = free;
    }
  }

  // Tells the follower where the edges go: of the depth (0) or of layer `quantity` - 1.
  void record(const LineBatch& b, int quantity) {
    if (in_.listener == nullptr) return;
    PaintEdges& edges = in_.listener->edges();
    Field<float>& plane = (axis_ == Axis::kX ? edges.x : edges.y)[at(quantity)];
    for_inner_edges(b, [&](int first, int n, int x, int y) {
      std::copy_n(plan_.edge.data() + first, n, plane.row(y) + x);
    });
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  CanvasState& state_;
  const StepInput& in_;
  Axis axis_;
  RemapOptions depth_, amount_;
  RemapPlan plan_;
  RemapScratch scratch_;
  std::vector<float> flow_, push_;  // displacement of edges, in cells
  std::vector<bool> present_;
  std::vector<float> total_, share_, held_;  // of cells
  std::vector<std::vector<float>> layer_, middle_;
};

inline void advect_paint_in_batches(CanvasState& state, const StepInput& in, Axis axis,
                                    const WetCells& wet) {
  for_batches(wet, axis, in.threads, [&](int begin, int end, const auto& block_at) {
    PlainPaintMover mover(state, in, axis);
    for (int k = begin; k < end; ++k) mover.move(block_at(k));
  });
}

}  // namespace pentimento::conservative

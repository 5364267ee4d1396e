#include <algorithm>

#include "core/base/fetch_ahead.h"
#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/crowd_limit.h"
#include "core/fluid/conservative/advection/layer_speed_row.h"
#include "core/fluid/conservative/advection/line_batch.h"
#include "core/fluid/conservative/advection/paint_rows.h"
#include "core/fluid/conservative/advection/remap_far.h"
#include "core/fluid/conservative/advection/remap_rows.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

// All that one thread needs to move the paint of a run along x. The buffers are kept from run to
// run; a row of cells in them has one cell more at each end.
class PaintRow {
 public:
  PaintRow(CanvasState& state, const StepInput& in)
      : state_(state),
        in_(in),
        depth_options_{in.model.superbee, rounder_for(quantum_for(in.model.max_medium_m))},
        amount_options_{in.model.superbee, rounder_for(quantum_for(in.model.max_pigment))},
        painted_(state.pigment.size()),
        middle_(at(state.layers)),
        layer_(at(state.layers)) {}

  void move(const Run& r) {
    resize(r);
    // How far flow and push carry each edge. A run where no edge moves is left alone.
    if (!fill_edges() && in_.listener == nullptr) return;
    // The edges of the depth. Where they would crowd the paint, they give way.
    limit_depth();
    // Where in the film each layer lies, and what of the bottom layer is free (R18, R19).
    find_layers();
    // The depth moves with its edges, then each layer with edges of its own.
    move_depth();
    for (int layer = 0; layer < state_.layers; ++layer) move_layer(layer);
  }

 private:
  void resize(const Run& r) {
    r_ = r;
    n_ = r.size();
    if (n_ + 2 * kSide > flow_.width()) {
      for (Field<float>* f : {&flow_, &push_, &edge_, &tau_lo_, &tau_hi_, &stay_, &value_, &out_lo_,
                              &out_hi_, &total_, &below_, &share_, &held_})
        *f = Field<float>(n_ + 2 * kSide, 1);
      for (std::vector<Field<float>>* layers : {&middle_, &layer_})
        for (Field<float>& f : *layers) f = Field<float>(n_ + 2 * kSide, 1);
    }
    cells(edge_)[0] = cells(edge_)[n_] = 0;
    cells(out_hi_)[-1] = cells(out_lo_)[n_] = 0;  // nothing comes through the walls
  }
  static float* cells(Field<float>& f) { return f.row(0) + kSide; }
  float* row_of(Field<float>& plane) const { return plane.row(r_.y) + r_.x0; }

  // Edge e of n + 1 lies before cell e; the first and the last are walls. Returns whether any edge
  // moves.
  bool fill_edges() {
    const float per_m = 1 / state_.geometry.dx_m();
    float* flow = cells(flow_);
    float* push = cells(push_);
    flow_row(row_of(state_.velocity_x_m_s), in_.dt_s, per_m, n_ - 1, flow + 1);
    flow[0] = flow[n_] = 0;
    bool moves = any_motion_row(flow, n_ + 1);
    std::fill_n(push, n_ + 1, 0.0f);
    if (r_.y >= in_.contact.row_begin && r_.y < in_.contact.row_end) {
      const float* here = in_.contact.push_x_m.row(r_.y) + r_.x0;
      push_row(here, here + 1, per_m, n_ - 1, push + 1);
      moves |= any_motion_row(push, n_ + 1);
    }
    return moves;
  }

  // Finds the edges of the depth. Where edges come too near one another, they and the flow give way
  // (crowd_limit.h).
  void limit_depth() {
    float* edge = cells(edge_);
    depth_edge_row(cells(flow_), cells(push_), n_ + 1, edge);
    const float* depth = load(row_of(state_.depth_m));
    const float most_m = kMostDepthShare * in_.model.max_medium_m;
    if (count_crowded_row({edge, edge + 1, depth - 1, depth, depth + 1}, most_m, n_) == 0) return;
    limit_crowding({n_, 1, most_m}, depth, edge);
    flow_of_edge_row(edge, cells(push_), n_ + 1, cells(flow_));
  }

  // A copy of a row with its ends mirrored.
  float* load(const float* from) {
    float* value = cells(value_);
    std::copy_n(from, n_, value);
    mirror_ends(value, n_);
    return value;
  }

  // Finds which layers the cells have, where these lie in the film, and which share of the bottom
  // layer may move.
  void find_layers() {
    if (r_.y + kRowsAhead < state_.geometry.height)
      for (const Field<float>& plane : state_.pigment)
        fetch_ahead(plane.row(r_.y + kRowsAhead) + r_.x0, n_);
    std::fill_n(cells(share_), n_, 0.0f);
    std::fill_n(cells(total_), n_, 0.0f);
    std::fill_n(cells(below_), n_, 0.0f);
    for (int k = 0; k < state_.layers; ++k) {
      float* layer = cells(layer_[at(k)]);
      std::fill_n(layer, n_, 0.0f);
      weigh_channels(
          state_.channels, in_.amount.data(), [&](int c) { return row_of(state_.channel(k, c)); },
          n_, layer, [&](int c, bool some) { painted_[at(k * state_.channels + c)] = some; });
      if (k == 0) free_row(in_.model.pigment_residue, n_, layer, cells(share_));
      if (painted(k)) add_row(layer, n_, cells(total_));
    }
    for (int k = 0; k < state_.layers; ++k)
      if (painted(k) || in_.listener != nullptr)
        layer_middle_row(cells(layer_[at(k)]), cells(total_), n_, cells(below_),
                         cells(middle_[at(k)]));
  }
  bool painted(int layer) const {
    const auto begin = painted_.begin() + layer * state_.channels;
    return std::find(begin, begin + state_.channels, true) != begin + state_.channels;
  }

  // Plans where the cells go, from edge_. Cells that go further than the next cell are listed in
  // far_.
  void plan() {
    const float* edge = cells(edge_);
    float* stay = cells(stay_);
    plan_remap_row(edge, edge + 1, n_, cells(tau_lo_), cells(tau_hi_), stay);
    far_.clear();
    if (count_far_row(stay, n_) == 0) return;
    for (int i = 0; i < n_; ++i)
      if (stay[i] == 0) far_.push_back(i);
  }

  void move_depth() {
    record(0);
    plan();
    move_quantity(depth_options_, load(row_of(state_.depth_m)), row_of(state_.depth_m));
  }

  void move_layer(int k) {
    if (!painted(k) && in_.listener == nullptr) return;
    const float* middle = cells(middle_[at(k)]);
    layer_speed_row(in_.model.layer_speed, middle, middle + 1, cells(flow_) + 1, cells(push_) + 1,
                    n_ - 1, cells(edge_) + 1);
    record(1 + k);
    if (!painted(k)) return;
    plan();
    for (int c = 0; c < state_.channels; ++c) {
      if (!painted_[at(k * state_.channels + c)]) continue;
      float* amount = row_of(state_.channel(k, c));
      if (k == 0)
        move_bottom(amount);
      else
        move_quantity(amount_options_, load(amount), amount);
    }
  }

  // Moves what is free of one channel of the bottom layer; the residue stays (R19).
  void move_bottom(float* amount) {
    float* free = cells(value_);
    split_residue_row(amount, cells(share_), amount_options_.rounder, n_, cells(held_), free);
    mirror_ends(free, n_);
    leave(amount_options_, free);
    gather_beside_rows(cells(stay_), parts(), free, cells(held_), n_, amount);
    add_far(amount_options_, free, amount);
  }

  // Moves one quantity. `value` is a copy of `amount` with its ends mirrored.
  void move_quantity(const RemapOptions& options, const float* value, float* amount) {
    // Near cells pass parts to their neighbours, then all cells take what came.
    leave(options, value);
    gather_rows(cells(stay_), parts(), n_, amount);
    add_far(options, value, amount);
  }

  // What leaves the cells of a quantity over their edges.
  void leave(const RemapOptions& options, const float* value) {
    flux_rows(options, {cells(tau_lo_), cells(tau_hi_)}, {value - 1, value, value + 1}, n_,
              cells(out_lo_), cells(out_hi_));
  }
  Parts parts() {
    const float* lo = cells(out_lo_);
    const float* hi = cells(out_hi_);
    return {hi - 1, hi, lo, lo + 1};
  }
  // Far cells passed nothing yet: each is spread over the cells that its image covers.
  void add_far(const RemapOptions& options, const float* value, float* amount) {
    if (far_.empty()) return;
    const std::vector<FarCell> far =
        take_far_cells(far_, cells(edge_), options, {value - 1, value, value + 1});
    const FarLine line{n_, r_.x0};
    put_far_cells(far, line, options.rounder, [&](int i, int) -> float& { return amount[i]; });
  }

  // Tells the listener where the edges go: those of the depth (0), or of layer `quantity` - 1.
  void record(int quantity) {
    if (in_.listener == nullptr) return;
    std::copy_n(cells(edge_) + 1, n_ - 1, row_of(in_.listener->edges().x[at(quantity)]));
  }

  static constexpr int kSide = 16;  // one cache line of floats
  CanvasState& state_;
  const StepInput& in_;
  RemapOptions depth_options_, amount_options_;
  std::vector<bool> painted_;  // per layer and channel: whether the row has any of it
  Run r_;
  int n_ = 0;
  Field<float> flow_, push_, edge_;  // displacement of edges, in cells
  Field<float> tau_lo_, tau_hi_, stay_, value_, out_lo_, out_hi_;
  Field<float> total_, below_, share_, held_;
  std::vector<Field<float>> middle_, layer_;  // of each layer: where it lies, and how much moves
  std::vector<int> far_;
};

}  // namespace

void advect_paint_along_x(CanvasState& state, const StepInput& in, const WetCells& wet) {
  const std::vector<Run>& runs = wet.runs();
  in.threads.for_ranges(0, static_cast<int>(runs.size()), 8, [&](int begin, int end) {
    PaintRow row(state, in);
    for (int k = begin; k < end; ++k) row.move(runs[at(k)]);
  });
}

}  // namespace pentimento::conservative

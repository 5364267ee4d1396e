#include <algorithm>

#include "core/base/fetch_ahead.h"
#include "core/fluid/conservative/advection/advection.h"
#include "core/fluid/conservative/advection/crowd_limit.h"
#include "core/fluid/conservative/advection/layer_speed_row.h"
#include "core/fluid/conservative/advection/line_batch.h"
#include "core/fluid/conservative/advection/paint_rows.h"
#include "core/fluid/conservative/advection/remap_stream.h"
#include "core/fluid/conservative/tiles/quantum.h"

namespace pentimento::conservative {
namespace {

std::size_t as_size(int i) {
  return static_cast<std::size_t>(i);
}

// For each of the three rows in a window: whether it has something.
struct RowFlags {
  std::array<bool, 3> flag{};
  bool& at(int r) { return flag[static_cast<std::size_t>((r + 3) % 3)]; }
};

// How far the edges of a batch of columns move, in cells: by the flow, by the push, and the edges
// of the depth by both. The rows of edges go from 0 to the height.
class BatchEdges {
 public:
  void fill(const CanvasState& state, const StepInput& in, const LineBatch& b, int tile_width) {
    width_ = b.width();
    const std::size_t edges = as_size(b.cells() + width_);
    for (std::vector<float>* v : {&flow_, &depth_})
      if (v->size() < edges) v->resize(edges);
    // Flow and push of each row of edges; the first and the last row are walls.
    pushed_ =
        !in.contact.empty() && in.contact.row_begin <= b.box.y1 && in.contact.row_end >= b.box.y0;
    push_.assign(pushed_ ? edges : as_size(width_), 0);
    moves_.assign(as_size(b.height() + 1), 0);
    for (const int r : {0, b.height()}) std::fill_n(flow_.data() + r * width_, width_, 0.0f);
    for (int r = 1; r < b.height(); ++r) fill_row(state, in, b, r);
    for (int r = 0; r <= b.height(); ++r)
      depth_edge_row(flow(r), push(r), width_, depth_.data() + r * width_);
    // The edges of the depth, limited strip by strip, so that it does not matter how many strips
    // make a batch.
    const float most_m = kMostDepthShare * in.model.max_medium_m;
    for (int x = b.box.x0; x < b.box.x1; x = end_of_tile(x, tile_width))
      limit_strip(state, b, x - b.box.x0, std::min(end_of_tile(x, tile_width), b.box.x1) - x,
                  most_m);
  }
  const float* flow(int r) const { return flow_.data() + r * width_; }
  const float* push(int r) const { return push_.data() + (pushed_ ? r * width_ : 0); }
  const float* depth(int r) const { return depth_.data() + r * width_; }
  bool moves(int r) const { return moves_[as_size(r)] != 0; }
  /// Whether any row of edges from `first` to `last` moves. They may lie beyond the batch.
  bool any_moves(int first, int last) const {
    const int rows = static_cast<int>(moves_.size());
    for (int r = std::max(first, 0); r <= std::min(last, rows - 1); ++r)
      if (moves(r)) return true;
    return false;
  }

 private:
  void fill_row(const CanvasState& state, const StepInput& in, const LineBatch& b, int r) {
    const float per_m = 1 / state.geometry.dy_m();
    const int x = b.box.x0;
    const int y = b.box.y0 + r - 1;
    float* flow = flow_.data() + r * width_;
    flow_row(state.velocity_y_m_s.row(y) + x, in.dt_s, per_m, width_, flow);
    moves_[as_size(r)] = any_motion_row(flow, width_);
    if (y + 1 < in.contact.row_begin || y >= in.contact.row_end) return;
    float* push = push_.data() + r * width_;
    push_row(in.contact.push_y_m.row(y) + x, in.contact.push_y_m.row(y + 1) + x, per_m, width_,
             push);
    if (any_motion_row(push, width_)) moves_[as_size(r)] = 1;
  }

  // Where edges of a strip come too near one another, they and the flow give way (crowd_limit.h).
  void limit_strip(const CanvasState& state, const LineBatch& b, int x0, int n, float most_m) {
    const int height = b.height();
    const auto depth = [&](int r) {
      return state.depth_m.row(b.box.y0 + std::clamp(r, 0, height - 1)) + b.box.x0 + x0;
    };
    // Most strips have no cell that is too narrow; they are left alone.
    int crowded = 0;
    for (int r = 0; r < height; ++r) {
      if (!moves(r) && !moves(r + 1)) continue;
      const CrowdRow row{this->depth(r) + x0, this->depth(r + 1) + x0, depth(r - 1), depth(r),
                         depth(r + 1)};
      crowded += count_crowded_row(row, most_m, n);
    }
    if (crowded == 0) return;
    // The limit works on flat arrays of the strip; what it moved is copied back.
    std::vector<float> strip_depth(as_size(n * (height + 2))), edge(as_size(n * (height + 1)));
    for (int r = -1; r <= height; ++r) std::copy_n(depth(r), n, strip_depth.data() + (r + 1) * n);
    for (int r = 0; r <= height; ++r) std::copy_n(this->depth(r) + x0, n, edge.data() + r * n);
    if (!limit_crowding({height, n, most_m}, strip_depth.data() + n, edge.data())) return;
    for (int r = 0; r <= height; ++r) {
      std::copy_n(edge.data() + r * n, n, depth_.data() + r * width_ + x0);
      float* flow = flow_.data() + r * width_ + x0;
      flow_of_edge_row(edge.data() + r * n, push(r) + x0, n, flow);
      moves_[as_size(r)] = 1;
    }
  }

  int width_ = 0;
  bool pushed_ = false;
  std::vector<float> flow_, push_, depth_;  // displacement of edges, in cells
  std::vector<std::uint8_t> moves_;         // whether any edge of a row moves
};

// One channel of one layer on its way through the window.
struct ChannelStream {
  QuantityStream quantity;
  RowFlags painted;
  RowRing free, held;  // of the bottom layer: what may move, what stays
};

// All that one thread needs to move the paint of a batch of columns along y. The buffers are kept
// from batch to batch.
class PaintStream {
 public:
  PaintStream(CanvasState& state, const StepInput& in, int tile_width)
      : state_(state),
        in_(in),
        tile_width_(tile_width),
        depth_options_{in.model.superbee, rounder_for(quantum_for(in.model.max_medium_m))},
        amount_options_{in.model.superbee, rounder_for(quantum_for(in.model.max_pigment))},
        layers_(as_size(state.layers)) {}

  void move(const LineBatch& b) {
    resize(b);
    // How far each edge moves, for the whole batch.
    edges_.fill(state_, in_, b, tile_width_);
    const int height = b.height();
    // A listener is told of edges at rest, too.
    if (in_.listener == nullptr && !edges_.any_moves(0, height)) return;
    // Down the rows. Each turn finds what leaves row r, while rows r - 1 and r + 1 are still as
    // they were, and then writes row r - 1, for which all that comes in is known.
    prepare(0);
    for (int r = 0; r <= height; ++r) {
      if (r + 1 < height) prepare(r + 1);
      move_depth(r);
      for (int layer = 0; layer < state_.layers; ++layer) move_layer(layer, r);
    }
    // Far cells are added last, to rows that are done.
    put_far();
  }

 private:
  struct StreamedLayer {
    EdgeStream edges;
    RowRing edge;
    RowRing middle;       // where the layer lies in the film
    Field<float> sum;     // of its pigment in the row that is prepared
    int edges_done = -1;  // the last row of edges in `edge`
    RowFlags painted;
    std::vector<ChannelStream> channels;
  };

  void resize(const LineBatch& b) {
    b_ = b;
    const int n = b.width();
    if (n != n_) {
      n_ = n;
      if (n > zeros_.width())
        for (Field<float>* row : {&zeros_, &total_, &below_}) *row = Field<float>(n, 1);
      share_.resize(n);
      depth_edges_.resize(n);
      depth_.resize(n);
      for (StreamedLayer& layer : layers_) resize(layer, &layer == layers_.data());
    }
    depth_.begin();
    for (StreamedLayer& layer : layers_) {
      layer.edges_done = -1;
      for (ChannelStream& c : layer.channels) c.quantity.begin();
    }
  }
  void resize(StreamedLayer& layer, bool bottom) {
    layer.edges.resize(n_);
    layer.edge.resize(n_);
    layer.middle.resize(n_);
    if (n_ > layer.sum.width()) layer.sum = Field<float>(n_, 1);
    layer.channels.resize(as_size(state_.channels));
    for (ChannelStream& c : layer.channels) {
      c.quantity.resize(n_);
      if (!bottom) continue;
      c.free.resize(n_);
      c.held.resize(n_);
    }
  }

  float* row_of(Field<float>& plane, int r) { return plane.row(b_.box.y0 + r) + b_.box.x0; }
  bool within(int r) const { return r >= 0 && r < b_.height(); }
  int clamped(int r) const { return std::clamp(r, 0, b_.height() - 1); }

  // Reads row r before it moves: which layers it has, where these lie in the film, and what of the
  // bottom layer is free to move. That matters to what leaves the row and its neighbours, and to
  // how the layers' edges move on either side of it.
  void prepare(int r) {
    if (!edges_.any_moves(r - 1, r + 2)) return;
    if (r + kRowsAhead < b_.height())
      for (Field<float>& plane : state_.pigment) fetch_ahead(row_of(plane, r + kRowsAhead), n_);
    float* total = total_.row(0);
    float* below = below_.row(0);
    float* share = share_.row(r);
    for (float* row : {total, below, share}) std::fill_n(row, n_, 0.0f);
    for (int k = 0; k < state_.layers; ++k) {
      StreamedLayer& layer = layers_[as_size(k)];
      float* sum = layer.sum.row(0);
      std::fill_n(sum, n_, 0.0f);
      bool painted = false;
      weigh_channels(
          state_.channels, in_.amount.data(),
          [&](int c) { return row_of(state_.channel(k, c), r); }, n_, sum,
          [&](int c, bool some) {
            layer.channels[as_size(c)].painted.at(r) = some;
            painted |= some;
          });
      layer.painted.at(r) = painted;
      if (k == 0 && painted) free_row(in_.model.pigment_residue, n_, sum, share);
      if (painted) add_row(sum, n_, total);
    }
    for (StreamedLayer& layer : layers_) {
      // The middle of each layer in the film (R18).
      if (layer.painted.at(r))
        layer_middle_row(layer.sum.row(0), total, n_, below, layer.middle.row(r));
      else
        std::fill_n(layer.middle.row(r), n_, 0.0f);
    }
    // What of the bottom layer is free, and what its residue holds (R19).
    if (!layers_.front().painted.at(r)) return;
    for (int c = 0; c < state_.channels; ++c) {
      ChannelStream& channel = layers_.front().channels[as_size(c)];
      if (!channel.painted.at(r)) continue;
      split_residue_row(row_of(state_.channel(0, c), r), share, amount_options_.rounder, n_,
                        channel.held.row(r), channel.free.row(r));
    }
  }

  // What leaves row r, then what row r - 1 becomes.
  void move_depth(int r) {
    if (within(r)) {
      depth_edges_.plan(r, edges_.depth(r), edges_.depth(r + 1),
                        edges_.moves(r) || edges_.moves(r + 1));
      const ThreeRows rows{row_of(state_.depth_m, clamped(r - 1)), row_of(state_.depth_m, r),
                           row_of(state_.depth_m, clamped(r + 1))};
      depth_.flux(depth_edges_, depth_options_, r, rows, true);
      if (r > 0) record(0, r, edges_.depth(r));
    } else {
      depth_.end(r);
    }
    if (r > 0) depth_.gather(depth_edges_, r - 1, row_of(state_.depth_m, r - 1));
  }

  // The same for layer k, over edges of its own, which are computed when a row needs them.
  void move_layer(int k, int r) {
    StreamedLayer& layer = layers_[as_size(k)];
    if (within(r)) {
      // A row without this layer passes nothing on, whatever its edges do.
      const bool moves = layer.painted.at(r) && (edges_.moves(r) || edges_.moves(r + 1));
      if (moves || (in_.listener != nullptr && r + 1 < b_.height())) {
        fill_edges(k, r);
        fill_edges(k, r + 1);
      }
      layer.edges.plan(r, layer.edge.row(r), layer.edge.row(r + 1), moves);
    }
    for (int c = 0; c < state_.channels; ++c) move_channel(k, c, r);
  }

  // Fills row r of the edges of layer k, which lies between the rows of cells r - 1 and r.
  void fill_edges(int k, int r) {
    StreamedLayer& layer = layers_[as_size(k)];
    if (layer.edges_done >= r) return;
    layer.edges_done = r;
    float* edge = layer.edge.row(r);
    if (r == 0 || r == b_.height()) {
      std::fill_n(edge, n_, 0.0f);
      return;
    }
    layer_speed_row(in_.model.layer_speed, layer.middle.row(r - 1), layer.middle.row(r),
                    edges_.flow(r), edges_.push(r), n_, edge);
    record(1 + k, r, edge);
  }

  void move_channel(int k, int c, int r) {
    ChannelStream& channel = layers_[as_size(k)].channels[as_size(c)];
    const EdgeStream& edges = layers_[as_size(k)].edges;
    Field<float>& plane = state_.channel(k, c);
    if (within(r)) {
      const auto row = [&](int i) -> const float* {
        const int j = clamped(i);
        if (!channel.painted.at(j)) return zeros_.row(0);
        return k == 0 ? channel.free.row(j) : row_of(plane, j);
      };
      channel.quantity.flux(edges, amount_options_, r, {row(r - 1), row(r), row(r + 1)},
                            channel.painted.at(r));
    } else {
      channel.quantity.end(r);
    }
    if (r == 0) return;
    float* amount = row_of(plane, r - 1);
    if (k != 0 || !channel.painted.at(r - 1)) {
      channel.quantity.gather(edges, r - 1, amount);
      return;
    }
    channel.quantity.gather_beside(edges, r - 1, channel.free.row(r - 1), channel.held.row(r - 1),
                                   amount);
  }

  void put_far() {
    const auto put = [&](const QuantityStream& quantity, float rounder, Field<float>& plane) {
      if (quantity.far().empty()) return;
      const FarLine line{b_.height(), b_.box.y0};
      put_far_cells(quantity.far(), line, rounder,
                    [&](int r, int lane) -> float& { return row_of(plane, r)[lane]; });
    };
    put(depth_, depth_options_.rounder, state_.depth_m);
    for (int k = 0; k < state_.layers; ++k)
      for (int c = 0; c < state_.channels; ++c)
        put(layers_[as_size(k)].channels[as_size(c)].quantity, amount_options_.rounder,
            state_.channel(k, c));
  }

  // Tells the listener where row r of the edges goes: those of the depth (0), or of layer
  // `quantity` - 1.
  void record(int quantity, int r, const float* edge) {
    if (in_.listener == nullptr) return;
    std::copy_n(edge, n_, row_of(in_.listener->edges().y[as_size(quantity)], r - 1));
  }

  CanvasState& state_;
  const StepInput& in_;
  int tile_width_;
  RemapOptions depth_options_, amount_options_;
  LineBatch b_;
  int n_ = 0;
  BatchEdges edges_;
  Field<float> zeros_, total_, below_;
  RowRing share_;
  EdgeStream depth_edges_;
  QuantityStream depth_;
  std::vector<StreamedLayer> layers_;
};

}  // namespace

void advect_paint_along_y(CanvasState& state, const StepInput& in, const WetCells& wet) {
  for_wide_batches(wet, in.threads, [&](int begin, int end, const auto& block_at) {
    PaintStream stream(state, in, wet.tile_width());
    for (int k = begin; k < end; ++k) stream.move(block_at(k));
  });
}

}  // namespace pentimento::conservative

#include "core/detail/flow/advect_detail.h"

#include <algorithm>

#include "core/base/any_not_zero.h"
#include "core/detail/flow/fine_edges.h"
#include "core/detail/flow/fine_remap.h"

namespace pentimento {

namespace {
constexpr int kLinesPerTask = 16;

/// Moves single lines of a run. The buffers are kept from line to line.
class LineMover {
 public:
  LineMover(DetailCanvas& canvas, const PaintEdges& edges, const DetailAdvection& move)
      : canvas_(canvas), edges_(edges), move_(move), k_(canvas.layout().factor()) {}

  void begin(const TileRun& run) {
    run_ = &run;
    present_.clear();
    for (int p = -1; p < canvas_.layers() * canvas_.channels(); ++p)
      present_.push_back(has_plane(canvas_, run, WetPlane{p}));
  }

  void move(int line) {
    // The guide's motion along this line; a line without motion stays.
    if (!find_edges(line)) return;
    const std::size_t blocks = at(run_->length());
    // Pieces of the line that move, each by itself: depth, then the channels of each layer.
    for (std::size_t from = 0; from < blocks; ++from) {
      if (blended_[from + 1] == 0) continue;
      std::size_t to = from + 1;
      while (to < blocks && (blended_[to] != 0 || blended_[to + 1] != 0)) ++to;
      take_part(from, to);
      move_depth(line);
      for (int layer = 0; layer < canvas_.layers(); ++layer) move_layer(layer, line);
      from = to;
    }
  }

 private:
  /// Finds how far the guide's edges go along the line, between two rows of the guide. False if
  /// none moves.
  bool find_edges(int line) {
    const float across = (static_cast<float>(line) + 0.5f) / static_cast<float>(k_) - 0.5f;
    const int low = across < 0 ? -1 : static_cast<int>(across);
    const int first = std::max(low, -before_run()), second = std::min(low + 1, behind_run() - 1);
    read_edges(first, a_);
    read_edges(second, b_);
    blended_.resize(a_.size());
    return blend_edges(a_, b_, across - static_cast<float>(low), blended_);
  }

  /// Takes the blocks [from, to) of the line as the part to move. The edges at both ends stand
  /// still, so the parts of a line do not touch one another.
  void take_part(std::size_t from, std::size_t to) {
    part_.assign(blended_.begin() + static_cast<std::ptrdiff_t>(from),
                 blended_.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    begin_ = static_cast<int>(from) * k_;
    const std::size_t cells = (to - from) * at(k_);
    position_.resize(cells + 1);
    // Where the fine edges go, and from which fine cells each cell is then made.
    place_edges(part_, k_, position_);
    find_sources(position_, sources_);
    value_.resize(cells + 2);
    share_.resize(cells);
    held_.resize(cells);
    out_.resize(cells);
    scratch_.resize(cells + 1);
  }

  /// How many rows the guide has before the run's first row, and how many from that row on: edges
  /// are read beyond the run.
  int before_run() const { return run_->axis == Axis::kX ? run_->box.y0 : run_->box.x0; }
  int behind_run() const {
    const CanvasGeometry& g = canvas_.layout().guide();
    return (run_->axis == Axis::kX ? g.height : g.width) - before_run();
  }

  void read_edges(int across, std::vector<float>& out) const {
    const std::size_t blocks = at(run_->length());
    out.assign(blocks + 1, 0.0f);
    if (run_->axis == Axis::kX) {
      const float* row = edges_.x[0].row(run_->box.y0 + across) + run_->box.x0;
      std::copy_n(row, blocks - 1, out.begin() + 1);
    } else {
      const Field<float>& plane = edges_.y[0];
      for (std::size_t i = 0; i + 1 < blocks; ++i)
        out[i + 1] = plane(run_->box.x0 + across, run_->box.y0 + static_cast<int>(i));
    }
  }

  void load(const WetPlane& q, int line) {
    const std::span<float> cells{value_.data() + 1, out_.size()};
    load_line(canvas_, *run_, q, line, begin_, cells);
    value_.front() = cells.front();
    value_.back() = cells.back();
  }

  void move_depth(int line) {
    const WetPlane depth;
    load(depth, line);
    remap_line(sources_, value_, scratch_, out_);
    store_line(canvas_, *run_, depth, line, begin_, out_);
  }

  void move_layer(int layer, int line) {
    if (layer == 0) find_share(line);
    for (int c = 0; c < canvas_.channels(); ++c) {
      const WetPlane q{layer * canvas_.channels() + c};
      if (!present_[at(1 + q.pigment)]) continue;
      load(q, line);
      if (!any_not_zero(value_.data(), static_cast<int>(value_.size()))) continue;
      if (layer == 0) split_residue();
      remap_line(sources_, value_, scratch_, out_);
      if (layer == 0)
        for (std::size_t i = 0; i < out_.size(); ++i) out_[i] += held_[i];
      store_line(canvas_, *run_, q, line, begin_, out_);
    }
  }

  /// Finds the share of layer 0 that may leave the paper (R19).
  void find_share(int line) {
    std::fill(share_.begin(), share_.end(), 0.0f);
    for (int c = 0; c < canvas_.channels(); ++c) {
      const float amount = move_.amount[at(c)];
      if (amount == 0 || !present_[at(1 + c)]) continue;
      load_line(canvas_, *run_, WetPlane{c}, line, begin_, out_);
      for (std::size_t i = 0; i < out_.size(); ++i) share_[i] += amount * out_[i];
    }
    for (float& s : share_) s = s > move_.residue ? (s - move_.residue) / s : 0.0f;
  }

  // Takes the residue out of value_ into held_. It is added again once the rest has moved.
  void split_residue() {
    for (std::size_t i = 0; i < held_.size(); ++i) {
      const float free = value_[i + 1] * share_[i];
      held_[i] = value_[i + 1] - free;
      value_[i + 1] = free;
    }
    value_.front() = value_[1];
    value_.back() = value_[value_.size() - 2];
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  DetailCanvas& canvas_;
  const PaintEdges& edges_;
  const DetailAdvection& move_;
  int k_;
  const TileRun* run_ = nullptr;
  std::vector<bool> present_;  // depth, then every pigment plane
  int begin_ = 0;              // first fine cell of the part that moves
  std::vector<float> a_, b_, blended_, part_, position_;
  FineSources sources_;
  std::vector<float> value_, share_, held_, out_, scratch_;
};

/// Lines [begin, end) of a run.
struct LineTask {
  const TileRun* run;
  int begin, end;
};

/// The lines of a run along which something moves.
LineTask moving_lines(const TileRun& run, const ChangedBlocks& moving, int factor) {
  int first = run.breadth(), last = 0;
  for (const int tile : run.tiles) {
    const CellBox box = moving.box(tile);
    const bool along_x = run.axis == Axis::kX;
    first = std::min(first, along_x ? box.y0 - run.box.y0 : box.x0 - run.box.x0);
    last = std::max(last, along_x ? box.y1 - run.box.y0 : box.x1 - run.box.x0);
  }
  return {&run, first * factor, last * factor};
}
}  // namespace

void advect_detail(DetailCanvas& canvas, const PaintEdges& edges, Axis axis,
                   const ChangedBlocks& moving, const DetailAdvection& move,
                   const Threads& threads) {
  const std::vector<TileRun> runs = runs_of(canvas.layout(), moving, axis);
  std::vector<LineTask> tasks;
  const int k = canvas.layout().factor();
  for (const TileRun& run : runs) {
    // Runs are cut into tasks of some lines.
    const LineTask lines = moving_lines(run, moving, k);
    for (int line = lines.begin; line < lines.end; line += kLinesPerTask)
      tasks.push_back({&run, line, std::min(line + kLinesPerTask, lines.end)});
  }
  threads.for_ranges(0, static_cast<int>(tasks.size()), 1, [&](int begin, int end) {
    // Each line reads and writes only itself, so the lines may move in any order.
    LineMover mover(canvas, edges, move);
    for (int t = begin; t < end; ++t) {
      const LineTask& task = tasks[static_cast<std::size_t>(t)];
      mover.begin(*task.run);
      for (int line = task.begin; line < task.end; ++line) mover.move(line);
    }
  });
}

}  // namespace pentimento

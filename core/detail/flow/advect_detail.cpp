#include "core/detail/flow/advect_detail.h"

#include <algorithm>
#include <cstdint>

#include "core/base/any_not_zero.h"
#include "core/detail/flow/fine_remap.h"
#include "core/detail/flow/moving_parts.h"

namespace pentimento {

namespace {
constexpr int kLinesPerTask = 16;

/// Moves some lines of a run together, quantity by quantity, so that a tile's rows are read as they
/// lie. The buffers are kept from call to call.
class LineMover {
 public:
  LineMover(DetailCanvas& canvas, const PaintEdges& edges, const DetailAdvection& move)
      : canvas_(canvas), move_(move), moving_(canvas.layout(), edges) {}

  void begin(const TileRun& run) {
    run_ = &run;
    present_.clear();
    for (int p = -1; p < canvas_.layers() * canvas_.channels(); ++p)
      present_.push_back(has_plane(canvas_, run, WetPlane{p}));
  }

  void move(int line, int lines) {
    // The guide's motion along these lines, in parts; where nothing moves, paint stays.
    moving_.find(*run_, line, lines);
    range_.line = line;
    range_.lines = lines;
    // Blocks side by side in which any of the lines moves: depth, then the channels of each layer.
    const std::vector<std::uint8_t>& moves = moving_.moves();
    for (std::size_t from = 0; from < moves.size(); ++from) {
      if (moves[from] == 0) continue;
      std::size_t to = from + 1;
      while (to < moves.size() && moves[to] != 0) ++to;
      take_blocks(from, to);
      move_plane(WetPlane{});
      for (int layer = 0; layer < canvas_.layers(); ++layer) move_layer(layer);
      from = to;
    }
  }

 private:
  void take_blocks(std::size_t from, std::size_t to) {
    const int k = canvas_.layout().factor();
    range_.begin = static_cast<int>(from) * k;
    range_.cells = static_cast<int>(to - from) * k;
    const std::size_t values = at(range_.lines) * at(stride());
    value_.resize(values);
    share_.resize(values);
    held_.resize(at(range_.cells));
    out_.resize(at(range_.cells));
    scratch_.resize(at(range_.cells) + 1);
  }
  /// From line to line in the buffers, with a cell before and one behind each.
  int stride() const { return range_.cells + 2; }

  void load(const WetPlane& q) {
    load_lines(canvas_, *run_, q, range_, {value_.data() + 1, stride()});
  }

  /// Moves what the range has of a plane, but for the residue that layer 0 holds back.
  void move_plane(const WetPlane& q, bool holds_residue = false) {
    load(q);
    bool moved = false;
    for (const MovingPart& part : moving_.parts()) {
      const bool inside = part.begin >= range_.begin && part.begin < range_.begin + range_.cells;
      if (inside && move_part(part, holds_residue)) moved = true;
    }
    if (moved) store_lines(canvas_, *run_, q, range_, {value_.data() + 1, stride()});
  }

  /// False if nothing lies in the part.
  bool move_part(const MovingPart& part, bool holds_residue) {
    const std::size_t first = at(part.line) * at(stride()) + at(1 + part.begin - range_.begin);
    const std::size_t n = at(part.cells);
    if (!any_not_zero(value_.data() + first, part.cells)) return false;
    if (holds_residue) split_residue(first, n);
    // The cells at both ends repeat beyond them while the part moves.
    float* cell = value_.data() + first;
    const float before = cell[-1], behind = cell[n];
    cell[-1] = cell[0];
    cell[n] = cell[n - 1];
    remap_line(part.sources, {cell - 1, n + 2}, {scratch_.data(), n + 1}, {out_.data(), n});
    cell[-1] = before;
    cell[n] = behind;
    if (holds_residue)
      for (std::size_t i = 0; i < n; ++i) out_[i] += held_[i];
    std::copy_n(out_.data(), n, cell);
    return true;
  }

  void move_layer(int layer) {
    if (layer == 0) find_shares();
    for (int c = 0; c < canvas_.channels(); ++c) {
      const WetPlane q{layer * canvas_.channels() + c};
      if (present_[at(1 + q.pigment)]) move_plane(q, layer == 0);
    }
  }

  /// Finds the share of layer 0 that may leave the paper (R19).
  void find_shares() {
    std::fill(share_.begin(), share_.end(), 0.0f);
    for (int c = 0; c < canvas_.channels(); ++c) {
      const float amount = move_.amount[at(c)];
      if (amount == 0 || !present_[at(1 + c)]) continue;
      load(WetPlane{c});
      for (std::size_t i = 0; i < share_.size(); ++i) share_[i] += amount * value_[i];
    }
    for (float& s : share_) s = s > move_.residue ? (s - move_.residue) / s : 0.0f;
  }

  // Takes the residue of a part out of value_ into held_. It is added again once the rest has
  // moved.
  void split_residue(std::size_t first, std::size_t n) {
    for (std::size_t i = 0; i < n; ++i) {
      const float free = value_[first + i] * share_[first + i];
      held_[i] = value_[first + i] - free;
      value_[first + i] = free;
    }
  }

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }

  DetailCanvas& canvas_;
  const DetailAdvection& move_;
  const TileRun* run_ = nullptr;
  std::vector<bool> present_;  // depth, then every pigment plane
  MovingParts moving_;
  LineRange range_;                   // what is moved now
  std::vector<float> value_, share_;  // line after line
  std::vector<float> held_, out_, scratch_;
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
      mover.move(task.begin, task.end - task.begin);
    }
  });
}

}  // namespace pentimento

#include "core/detail/flow/moving_parts.h"

#include <algorithm>

#include "core/detail/flow/fine_edges.h"

namespace pentimento {

void MovingParts::find(const TileRun& run, int line, int lines) {
  used_ = 0;
  moves_.assign(static_cast<std::size_t>(run.length()), 0);
  for (int l = 0; l < lines; ++l)
    if (find_edges(run, line + l)) split(l);
}

/// Finds how far the guide's edges go along the line, between two rows of the guide. False if none
/// moves.
bool MovingParts::find_edges(const TileRun& run, int line) {
  // How many rows the guide has before the run's first one, and how many from that one on: edges
  // are read beyond the run.
  const CanvasGeometry& guide = layout_.guide();
  const bool along_x = run.axis == Axis::kX;
  const int before = along_x ? run.box.y0 : run.box.x0;
  const int behind = (along_x ? guide.height : guide.width) - before;
  const float across =
      (static_cast<float>(line) + 0.5f) / static_cast<float>(layout_.factor()) - 0.5f;
  const int low = across < 0 ? -1 : static_cast<int>(across);
  read_edges(run, std::max(low, -before), a_);
  read_edges(run, std::min(low + 1, behind - 1), b_);
  blended_.resize(a_.size());
  return blend_edges(a_, b_, across - static_cast<float>(low), blended_);
}

void MovingParts::read_edges(const TileRun& run, int across, std::vector<float>& out) const {
  const auto blocks = static_cast<std::size_t>(run.length());
  out.assign(blocks + 1, 0.0f);
  if (run.axis == Axis::kX) {
    const float* row = edges_.x[0].row(run.box.y0 + across) + run.box.x0;
    std::copy_n(row, blocks - 1, out.begin() + 1);
  } else {
    const Field<float>& plane = edges_.y[0];
    for (std::size_t i = 0; i + 1 < blocks; ++i)
      out[i + 1] = plane(run.box.x0 + across, run.box.y0 + static_cast<int>(i));
  }
}

/// Finds the parts of a line that move. The edges at both ends of a part stand still, so the parts
/// of a line do not touch one another.
void MovingParts::split(int line) {
  const std::size_t blocks = moves_.size();
  for (std::size_t from = 0; from < blocks; ++from) {
    if (blended_[from + 1] == 0) continue;
    std::size_t to = from + 1;
    while (to < blocks && (blended_[to] != 0 || blended_[to + 1] != 0)) ++to;
    add(line, from, to);
    for (std::size_t block = from; block < to; ++block) moves_[block] = 1;
    from = to;
  }
}

/// Adds the blocks [from, to) of a line: where the fine edges go, and from which fine cells each
/// cell is then made.
void MovingParts::add(int line, std::size_t from, std::size_t to) {
  if (used_ == parts_.size()) parts_.emplace_back();
  MovingPart& part = parts_[used_++];
  const int k = layout_.factor();
  part.line = line;
  part.begin = static_cast<int>(from) * k;
  part.cells = static_cast<int>(to - from) * k;
  position_.resize(static_cast<std::size_t>(part.cells) + 1);
  place_edges(std::span(blended_).subspan(from, to - from + 1), k, position_);
  find_sources(position_, part.sources);
}

}  // namespace pentimento

#pragma once
// Which parts of some lines of fine cells move, and from which cells each cell is then made.

#include <cstdint>
#include <span>
#include <vector>

#include "core/detail/flow/fine_remap.h"
#include "core/detail/store/detail_layout.h"
#include "core/detail/store/tile_line.h"
#include "core/fluid/paint_edges.h"

namespace pentimento {

/// Part of a line, between two edges of the guide that stand still, in which edges move.
struct MovingPart {
  int line = 0;              // among the lines that were looked at together
  int begin = 0, cells = 0;  // fine cells, counted from the run's first
  FineSources sources;
};

/// Finds the parts of lines side by side. Keeps its buffers from call to call. Not thread-safe.
class MovingParts {
 public:
  MovingParts(const DetailLayout& layout, const PaintEdges& edges)
      : layout_(layout), edges_(edges) {}

  /// Looks at `lines` lines of the run, from `line` on, with the edges of the guide's depth, which
  /// are interpolated between its rows.
  void find(const TileRun& run, int line, int lines);

  /// Line after line, and along each.
  std::span<const MovingPart> parts() const { return {parts_.data(), used_}; }
  /// For each block along the run, whether it lies in a part of any of the lines.
  const std::vector<std::uint8_t>& moves() const { return moves_; }

 private:
  bool find_edges(const TileRun& run, int line);
  void read_edges(const TileRun& run, int across, std::vector<float>& out) const;
  void split(int line);
  void add(int line, std::size_t from, std::size_t to);

  const DetailLayout& layout_;
  const PaintEdges& edges_;
  std::vector<MovingPart> parts_;
  std::size_t used_ = 0;
  std::vector<std::uint8_t> moves_;
  std::vector<float> a_, b_, blended_, position_;
};

}  // namespace pentimento

#pragma once
// Moves paint along one line of fine cells. It is the forward remap of the conservative scheme read
// backwards: for each edge it finds where that edge came from, because here every cell may move
// far.

#include <cstdint>
#include <span>
#include <vector>

namespace pentimento {

/// The source of each edge of the line: the cell, and the place in that cell, where the paint that
/// is now at the edge came from.
struct FineSources {
  std::vector<int> cell;
  std::vector<float> share;  // of the cell's length that lies before the edge, [0,1]
  int most = 0;              // most cells between the sources of two edges side by side
  // Per piece of the line, kEdgesTogether edges each: 1 if their sources and that of the edge
  // behind them lie in cells side by side, one each.
  std::vector<std::uint8_t> in_step;
  // Per piece: the source cell of its first edge, or the one before, if each other edge's is as far
  // on as the edge, or one more; else kNotNear.
  std::vector<int> near;
};
inline constexpr int kEdgesTogether = 16;
inline constexpr int kNotNear = -1;

/// Finds the sources for n + 1 ascending positions of moved edges (fine_edges.h), the first 0, the
/// last n.
void find_sources(std::span<const float> position, FineSources& sources);

/// Amounts per cell after the motion: what lies between the sources of a cell's two edges, under
/// the limited linear profile of each source cell.
///   part(i, s) = s (m_i - slope_i (1 - s) / 2);  m'_j = sum_{i_j <= i < i_{j+1}} m_i
///                + part(i_{j+1}, s_{j+1}) - part(i_j, s_j)
/// Scheme: piecewise linear, 2nd order where smooth, monotone. Stable: any displacement; values
/// stay >= 0 (rounding below 0 is cut), sums hold to rounding: the lock restores them.
/// Source: Lauritzen, Nair, Ullrich, J. Comput. Phys. 229 (2010) 1401-1424, in one dimension.
/// Departs from it: nothing.
/// `amount`: n cells with one ghost before and after; `part` scratch of n + 1; `out`: n.
void remap_line(const FineSources& sources, std::span<const float> amount, std::span<float> part,
                std::span<float> out);

}  // namespace pentimento

#pragma once
// The edge of a film that slants is a staircase of the guide's cells. This file makes it a line.

#include <vector>

namespace pentimento {

/// Evenness of an edge depends on cells no further than this.
inline constexpr int kEvenReach = 10;

/// Coverage of a plane of cells, f in [0, 1] with `width` cells a row; cells nearer than kEvenReach
/// to its border stay as they are. `film`: what the cells hold of the film that it is the coverage
/// of, or of a pigment in it. Where one of the 3 x 3 cells around is bare of film,
///   f' = min(1, max(e, mean of H(k) over |k| <= r, with weights r + 1 - |k|, less 2))
///   H(k): the film's cells on a line of five across the edge, two inside and two outside, k cells
///         further along the edge; the sum of f, from inside outward, as long as it does not rise
///   across: along x or y, whichever is nearer to the gradient of f over 5 x 5 cells
///   r: the largest up to 8 so that the edge crosses all lines (they begin in a whole cell and do
///      not end in one) and does not bend, (H(k) - H(0)) (H(-k) - H(0)) <= 1
///   e: 0.1 where f > 0, else 0
/// f' = f where the edge does not cross the line of the cell itself, and in grooves: where the sum
/// over 5 x 5 cells of f times the distance from the middle is below 5 along both axes.
/// A straight edge along x, along y or at 45 degrees stays as it is. A staircase with steps of up
/// to eight cells becomes a line through the middles of its steps.
/// Scheme: the height functions of volume-of-fluid methods, averaged along the edge.
/// Stable: bounded, and not iterated. Source: Cummins, Francois, Kothe, Computers & Structures 83
/// (2005) 425-434. Departs from it: the mean.
std::vector<float> even_edges(const std::vector<float>& coverage, const std::vector<float>& film,
                              int width, int height);

}  // namespace pentimento

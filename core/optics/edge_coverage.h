#pragma once
// How much of a cell wet paint covers where a film ends in it. A coarse cell at the edge of a film
// is not a thin film: it is part paint and part ground, and shows the mean of their light. Pure
// functions on rows. What dries into the state uses them too, so they compute in float, in a fixed
// order and without C library functions but sqrt.

#include <array>
#include <span>
#include <vector>

namespace pentimento {

/// Whether cells at the edge of a film are partly covered. A canvas that is finer than the guide
/// has its edges itself: there a cell is covered, or it is not.
enum class EdgeCells { kPartlyCovered, kCovered };

/// Wet paint thinner than this hides nothing: to the cells beside it, its cell is bare.
inline constexpr float kBareDepth_m = 1e-6f;
/// The way over which a film rises to its full depth, in cells. The edges of posters rise from 10
/// to 90 % over 0.4 to 0.8 of the guide's cells (docs/fidelity.md).
inline constexpr float kEdgeRise = 0.75f;
/// How many cells on each side of a cell its coverage depends on.
inline constexpr int kCoverageReach = 2;

/// Depth of wet paint (m) in the row, the two rows above it and the two below; each has
/// kCoverageReach cells more than the row at both ends. Beyond the grid they repeat its edge.
using CoverageRows = std::array<std::vector<float>, 2 * kCoverageReach + 1>;

/// Writes the share of each cell of the row that paint covers, in (0, 1].
///   a film that rises linearly to the depth D over w cells, and covers the share c of its last
///   cell, has there the mean depth  d = D c^2 / (2w)  if c <= w, else  D (c - w/2), hence
///   c = sqrt(2 w d / D)  if d / D < w/2, else  min(1, d / D + w/2),  w = kEdgeRise
/// in cells with paint that have a bare cell among their eight neighbours; 1 in all others. D is
/// the mean of those of the 3 x 3 cells that have no bare neighbour; where there is none, the
/// deepest. Scheme: pointwise on 5 x 5 cells. Stable: c in (0, 1] for any finite depth >= 0.
/// Source: the integral of the ramp; w is measured. Departs from it: D is lower than the film's
/// depth by up to the ramp's share in the next cell, which makes c at most 0.03 too large.
void edge_coverage_row(const CoverageRows& depth_m, std::span<float> coverage);

/// Reflectance of a cell of which paint covers `coverage`, as light sees it from outside:
///   V(R) = R / (1 - k2 R),  V = (1 - coverage) V(bare) + coverage V(film),  R = V / (1 + k2 V)
/// so that Saunderson's correction of R is the mean of both corrected. All in [0, 1].
inline float partly_covered(float bare, float film, float coverage, float k2) {
  const float v_bare = bare / (1 - k2 * bare), v_film = film / (1 - k2 * film);
  const float v = v_bare + coverage * (v_film - v_bare);
  return v / (1 + k2 * v);
}

}  // namespace pentimento

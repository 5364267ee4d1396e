#pragma once
// How much of a cell of the guide lies inside a film's edge: the mean of the edge's profile over
// it.

#include <array>

namespace pentimento {

/// Cells on each side whose coverage the mean depends on.
inline constexpr int kProfileReach = 2;
/// Most cells that one call takes.
inline constexpr int kProfileBatch = 64;

/// Coverage at and around n cells. Row 5 j + i: of the cells i - 2 to the right of them and j - 2
/// below, n values.
using CoverageAround = std::array<std::array<float, kProfileBatch>, 25>;

/// M of n cells, n <= kProfileBatch: the mean of m(W) (level_rows.h) over 4 x 4 points of the cell,
/// W the cubic B-spline with the coverage as coefficients (smooth_field.h), along the rows first.
/// Scheme: midpoint rule. Stable: pointwise, in [0, 1]. Source: film_spline.h.
void profile_mean_row(const CoverageAround& coverage, int n, float* mean);

}  // namespace pentimento

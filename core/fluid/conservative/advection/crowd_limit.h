#pragma once
// Keeps motion from piling up paint higher than a canvas carries: limits how far the edges of a
// batch may come together in one step.

namespace pentimento::conservative {

/// The lines of cells of a batch: `step` lines of `length` cells (remap_plan.h).
struct CrowdLines {
  int length = 0;
  int step = 1;
  float most_m = 0;  // depth that motion may not exceed
};

/// How high motion may pile paint, as a share of max_medium. With rounding it is 1.2.
constexpr float kMostDepthShare = 1.19f;

/// Moves edges that came closer together than the paint between them allows.
///   x_i = i + D_i; x_{i+1} - x_i >= min(1, d_i / most), d_i the deepest of the cell and its two
///   neighbours along the line: forward, then backward from the far wall
/// Scheme: a constraint; touches only edges in the way of others. Sums are the remap's business.
/// Stable: images of cells do not overlap and none is deeper than `most`, so no cell is after.
/// Source: ours; an inelastic collision. Without it, streams of a time step longer than
///   1 / |du/dx| pass through one another and pile up without bound (docs/numerics.md).
/// Departs from it: nothing.
/// `depth_m` has `step` more cells before and after; cell i lies between the edges i and i + `step`
/// of `edge`. Returns whether any edge moved.
bool limit_crowding(const CrowdLines& lines, const float* depth_m, float* edge);

/// A row of cells: its two rows of edges, its depth, and the depth of the cells before and after
/// it.
struct CrowdRow {
  const float* edge_lo;
  const float* edge_hi;
  const float* depth_before;
  const float* depth;
  const float* depth_after;
};
/// How many cells of a row limit_crowding would find too narrow.
int count_crowded_row(const CrowdRow& row, float most_m, int n);

}  // namespace pentimento::conservative

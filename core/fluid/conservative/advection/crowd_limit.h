#pragma once
// Keeps paint from piling up higher than a canvas carries: limits how far the edges of a batch may
// come together in one step.

namespace pentimento::conservative {

/// A batch's lines of cells: `step` lines of `length` cells (remap_plan.h).
struct CrowdLines {
  int length = 0;
  int step = 1;
  float most_m = 0;  // depth that motion may not exceed
};

/// Of max_medium: how high motion may pile paint; 1.2 with rounding.
constexpr float kMostDepthShare = 1.19f;

/// Moves edges that came closer than the paint between them allows.
///   x_i = i + D_i; x_{i+1} - x_i >= min(1, d_i / most), d_i the deepest of the cell and its two
///   neighbours along the line: forward, then backward from the far wall
/// Scheme: a constraint; touches only edges in the way of others. Sums are the remap's business.
/// Stable: images of cells do not overlap and none is deeper than `most`, so no cell is after.
/// Source: ours; an inelastic collision. Without it, streams of a time step longer than
///   1 / |du/dx| pass through one another and pile up without bound (docs/numerics.md).
/// Departs from it: nothing.
/// `depth_m` has `step` cells before and after; `edge` as in RemapPlan. Returns whether any moved.
bool limit_crowding(const CrowdLines& lines, const float* depth_m, float* edge);

/// A row of cells: their two rows of edges, their depth and that of their neighbours.
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

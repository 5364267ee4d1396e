#pragma once
// How far the edges of fine cells move along a line of the detail canvas, from the guide's edges.

#include <span>

namespace pentimento {

/// Displacements of the guide's edges, in guide cells, along a line at height `t` between the
/// centres of two of its rows (0: row a, 1: row b).
///   D = a + t (b - a)
/// Scheme: linear across the motion. Stable: nothing evolves. Source: docs/fidelity.md.
/// Departs from it: nothing. Returns whether any is not 0.
bool blend_edges(std::span<const float> a, std::span<const float> b, float t, std::span<float> out);

/// Positions of the fine edges after the motion, in fine cells from the line's start.
///   x_e = e + k D(e / k), D cubic between the guide's edges with the limited slopes of
///   limiter.h at them
/// then pushed apart where they would cross: x_{e+1} >= x_e + 1/64, from the left, then from the
/// right wall.
/// Scheme: D has a continuous derivative along the motion, so the stretch of the paint does not
/// jump between blocks (linear D prints their grid). Stable: positions ascend.
/// Source: forward remap, core/fluid/conservative/advection/remap_plan.h. Departs from it: edges of
/// layers that would cross (their factors differ from cell to cell) keep a sliver between them.
/// `guide` has one more value than the line has blocks and starts and ends with 0; `position` one
/// more than the line has fine cells.
void place_edges(std::span<const float> guide, int factor, std::span<float> position);

}  // namespace pentimento

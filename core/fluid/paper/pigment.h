#pragma once
// Advection of pigment, layer by layer (R18, R19).

#include "core/canvas/canvas_state.h"
#include "core/fluid/paper/planes.h"
#include "core/fluid/paper/step_constants.h"

namespace pentimento::paper {

/// Counts the layers that hold pigment in the cells of row y: n of R18 (A15).
void count_layers_row(const CanvasState& state, int y, Columns cells, Planes& planes);

/// Finds the share of the bottom layer of row y that is free to move: all beyond the residue (R19,
/// A17).
///   free = 1 - min(1, P_min / sum P of layer 0)
void find_free_row(const CanvasState& state, const std::vector<float>& amount, float residue, int y,
                   Columns cells, Planes& planes);

/// Velocity of layer k (0 = bottom) of n as a fraction of the surface's: linear from the canvas at
/// rest to the surface, taken at the middle of the layer (R18): (k + 1/2) / n. A layer that only
/// arrives with the paint counts itself: n is at least k + 1.
inline float layer_velocity_frac(int layer, int occupied) {
  const int n = occupied > layer ? occupied : layer + 1;
  return (static_cast<float>(layer) + 0.5f) / static_cast<float>(n);
}

/// Moves one layer's channels along row y, into planes.pigment.
///   P+(x) = P(x - dt u_k(x)), u_k = u (k + 1/2) / n; in layer 0 of the free part, and the rest of
///   P(x) stays
/// Scheme: semi-Lagrangian, bilinear, 1st order; amounts, not concentrations (A16). Stable for any
/// step; keeps no sum (A5). Source: R18, R19 (Stuyck et al. 2016, section 6). Departures: the
/// residue is a share of what is there, so it makes no pigment; amounts below kNoPigment vanish.
/// `u_m_s`, `v_m_s`: the new velocity. The departure point is found once for all channels.
void advect_pigment_row(const StepConstants& k, const CanvasState& state, int layer,
                        const float* u_m_s, const float* v_m_s, int y, Columns cells,
                        Planes& planes);

/// The plain way to do the same, cell by cell. advect_pigment_row() uses it for cells at the
/// canvas's edge, and where neighbours get pigment from cells that are not (near_departures.h).
void advect_pigment_cells(const StepConstants& k, const CanvasState& state, int layer,
                          const float* u_m_s, const float* v_m_s, int y, Columns cells,
                          Planes& planes);

/// Copies row y of the layer back from planes.pigment. Returns whether any bit changed.
bool store_pigment_row(const Planes& planes, int layer, int y, Columns cells, CanvasState& state);

/// Copies to planes.pigment what row y has outside `cells`, so that the planes can take the place
/// of the layer's. Returns whether any bit of `cells` differs.
bool complete_pigment_row(const CanvasState& state, int layer, int y, Columns cells,
                          Planes& planes);

/// Exchanges the layer's planes with planes.pigment.
void exchange_pigment(int layer, CanvasState& state, Planes& planes);

}  // namespace pentimento::paper

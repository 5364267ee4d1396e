#pragma once
// The reflectance of wet paint over the dry layer, per band: what drying leaves on the canvas (R20,
// R31). It reaches the state, so it is computed in float, in a fixed order and without C library
// functions. For pictures, shading/albedo_row.h computes the same faster.

#include <Eigen/Core>
#include <span>

#include "core/canvas/canvas_state.h"
#include "core/model/model.h"
#include "core/optics/channels.h"
#include "core/optics/edge_coverage.h"

namespace pentimento {

/// Below this pigment amount a layer counts as empty: it neither shares the depth of its cell nor
/// colours it (A23, R31).
inline constexpr float kEmptyLayerAmount = 1e-7f;

/// How channel amounts become K x and S x, x the optical thickness. In float, for rows.
struct CompositeOptics {
  Eigen::MatrixXf K;       // bands x channels
  Eigen::MatrixXf S;       // bands x channels
  Eigen::VectorXf amount;  // per channel
  OpticalThickness thickness = OpticalThickness::kAmount;
  float per_reference = 1;  // 1 / pigment_reference or 1 / depth_reference_m
  float k2 = 0;             // Saunderson's correction, for cells that are partly covered
};

/// Converts basis and model to the form that composite_row() needs.
CompositeOptics make_composite_optics(const ChannelBasis& basis, const Model& model);

/// Reflectance of row y: the state's layers, bottom first, over its dry reflectance.
///   per layer, kAmount (A28): K x = M_K c / P_ref, S x = M_S c / P_ref
///   per layer, kDepth: K x = (M_K c / P)(d / occupied layers) / d_ref, same for S, P = m c
///   film and stack as in kubelka_munk.h
///   where paint covers the share c of a cell: all of it lies there, K x / c and S x / c, and the
///   cell is partly_covered() by the stack (optics/edge_coverage.h)
/// Scheme: pointwise. Stability: any finite c, d >= 0; the result is in [0,1].
/// Source: R20, R31; Kubelka-Munk (Curtis et al. 1997, sec. 5.2).
/// Departs from it: layers under kEmptyLayerAmount are left out.
/// `coverage` has a share per cell, in (0, 1]; none: all 1. `reflectance` has one row of the grid's
/// width per band.
void composite_row(const CompositeOptics& optics, const CanvasState& state, int y,
                   std::span<const float> coverage, std::span<float* const> reflectance);

}  // namespace pentimento

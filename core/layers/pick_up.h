#pragma once
// The brush picks up wet paint from the canvas (R22, R23).

#include <algorithm>
#include <span>

#include "core/layers/layer_row.h"

namespace pentimento {

/// How a stamp picks up. `share_frac`: share of the paint in a layer that the bristles reach fully.
struct PickUp {
  float share_frac = 0;  // where the tip's weight is 1
  float penetration_frac =
      -1;             // how deep the bristles go, 0..1 of the film; negative: everywhere alike
  float residue = 0;  // amount of pigment of the bottom layer that stays on the paper (R19)
};

/// R23: how far the bristles reach into layer `layer` of `occupied` layers, 0..1. They reach the
/// topmost first.
inline float penetration_weight(float penetration_frac, int layer, int occupied) {
  const int from_top = occupied - 1 - layer;
  const float reach = std::clamp(
      penetration_frac * static_cast<float>(occupied) - static_cast<float>(from_top), 0.0f, 1.0f);
  return penetration_frac < 0 ? 1 : reach;
}

/// Picks up paint from the cells of a row.
///   P_k -= f w_k P_k,  d -= f mean(w_k) d,  f = min(1, share weight)
///   picked_up[x] = (height, channels) that left; sums = the same over the row, in double: exactly
///   what the planes lost (height first)
/// Scheme: pointwise. Stability: f, w_k in [0,1] leave everything >= 0.
/// Source: R22, R23; A20 (what the brush gains leaves the canvas, pigment and its share of medium).
/// Departs from it: the residue of R19 is not picked up.
/// `weight`, `depth_m`: one value per cell; `picked_up`: `stride` floats per cell, a multiple of
/// four, of which those beyond the channels become 0.
void pick_up_row(const PickUp& pick_up, const LayerRow& row, std::span<const float> weight,
                 float* depth_m, float* picked_up, int stride, std::span<double> sums);

}  // namespace pentimento

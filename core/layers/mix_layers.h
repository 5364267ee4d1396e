#pragma once
// The brush mixes the layers under it as it passes (R28).

#include <span>

#include "core/layers/layer_row.h"

namespace pentimento {

struct MixLayers {
  float exchange_frac = 0;  // m of A24 where the tip's weight is 1; <= 1/2
  float residue = 0;        // amount of pigment of the bottom layer that stays on the paper (R19)
};

/// Mixes once in the cells of a row, in layers 0 .. top of each cell.
///   P_k += m [(P_{k+1} - P_k) + (P_{k-1} - P_k)], m = min(1/2, exchange weight); no flux past the
///   ends
/// Scheme: explicit, all fluxes from the values before. Stability: m <= 1/2 (keeps P >= 0); in the
/// limit all layers hold the same. Source: R28, A24.
/// Departs from it: the residue of R19 does not leave the bottom layer.
void mix_layers_row(const MixLayers& mix, const LayerRow& row, std::span<const float> weight);

}  // namespace pentimento

#pragma once
// How far the paint of one layer is carried over each edge.

namespace pentimento::conservative {

struct LayerSpeed {
  int layer = 0;    // k, 0 = bottom
  float speed = 1;  // Model::layer_speed
};

/// Displacement in cells of the edges between cells a and b.
///   D = (speed flow + push) f;  f: mean over those of a, b that have layer k of (k + 1/2)/n
/// Scheme: pointwise, exact. Stable: nothing evolves.
/// Source: R18 (Stuyck et al. 2016, section 5.4).
/// Departs from it: n differs from cell to cell, so an edge takes the mean of its two cells.
/// `layers_a`, `layers_b`: occupied layers n of the cells on either side; 0 = bare.
void layer_speed_row(const LayerSpeed& p, const float* layers_a, const float* layers_b,
                     const float* flow, const float* push, int edges, float* out);

}  // namespace pentimento::conservative

#pragma once
// How far each edge of one layer moves.

namespace pentimento::conservative {

/// Height of the middle of a layer in the film: 0 is the bed, 1 the surface. 0 where the layer has
/// no paint.
///   z_k = (sum of a_j below k + a_k/2) / sum of a;  a_k: pigment of layer k that may move
/// Scheme: pointwise, exact. Stable: nothing evolves.
/// Source: R18 (Stuyck et al. 2016, section 5.4).
/// Departs from it: a layer is as thick as its share of the pigment, not 1/n of the film. With
///   velocities 2 z_k u the pigment of all layers together then moves with u, as its medium does;
///   layers of 1/n let the upper ones run ahead of the medium, which dams every front.
/// `below`: sum of a over all lower layers. The layer's own a is added to it.
void layer_middle_row(const float* layer, const float* total, int n, float* below, float* middle);

/// Displacement, in cells, of the edges between cells a and b.
///   D = (speed flow + push) f;  f: mean of z_k over the cells, a or b, that have the layer
/// Scheme: pointwise, exact. Stable: nothing evolves.
/// Source: R18.
/// Departs from it: z differs from cell to cell, so an edge takes the mean of its two cells.
/// `speed`: Model::layer_speed.
void layer_speed_row(float speed, const float* middle_a, const float* middle_b, const float* flow,
                     const float* push, int edges, float* out);

}  // namespace pentimento::conservative

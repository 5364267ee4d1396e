#pragma once
// Small row kernels for moving paint (advect_paint_x.cpp, advect_paint_y.cpp): the displacements of
// edges, which layers a cell has, how much of the bottom layer is free. All are pointwise and
// exact: they have no scheme, and nothing evolves.

#include <array>

namespace pentimento::conservative {

/// out = (u dt) per_m: displacement by the velocity, in cells. `per_m`: cells per metre.
void flow_row(const float* velocity_m_s, float dt_s, float per_m, int n, float* out);
/// out = (here + next)/2 per_m: the brush's push on the face between two cells, in cells.
void push_row(const float* here_m, const float* next_m, float per_m, int n, float* out);
/// out = flow + push/2: the depth takes half of the push, for (k + 1/2)/n is 1/2 in the mean over
/// layers.
void depth_edge_row(const float* flow, const float* push, int n, float* out);
/// flow = edge - push/2.
void flow_of_edge_row(const float* edge, const float* push, int n, float* flow);
/// sum += weight amount. Returns whether any value of `amount` is not 0.
bool weigh_row(const float* amount, float weight, int n, float* sum);
/// The same for four rows, one after the other. Bit k of what it returns is that of row k.
int weigh_four_rows(const std::array<const float*, 4>& amount, const float* weights, int n,
                    float* sum);
/// The same for all channels of a layer: row_of(c) is the row of channel c, and found(c, some) is
/// told whether any of its values is not 0.
template <typename RowOf, typename Found>
void weigh_channels(int channels, const float* weights, const RowOf& row_of, int n, float* sum,
                    const Found& found) {
  int c = 0;
  for (; c + 4 <= channels; c += 4) {
    const int some = weigh_four_rows({row_of(c), row_of(c + 1), row_of(c + 2), row_of(c + 3)},
                                     weights + c, n, sum);
    for (int k = 0; k < 4; ++k) found(c + k, (some >> k & 1) != 0);
  }
  for (; c < channels; ++c) found(c, weigh_row(row_of(c), weights[c], n, sum));
}
/// Turns the sum of pigment into the part of it that exceeds `residue`, and finds the share that
/// this part is of the sum (R19).
void free_row(float residue, int n, float* sum_to_free, float* share);
/// total += layer.
void add_row(const float* layer, int n, float* total);
/// free = share value, in whole quanta; held = value - free. `free` may be `value` itself.
void split_residue_row(const float* value, const float* share, float rounder, int n, float* held,
                       float* free);
/// Whether any edge moves.
bool any_motion_row(const float* edge, int n);
/// Whether any edge moves further than `limit` cells.
bool any_beyond_row(const float* edge, float limit, int n);

}  // namespace pentimento::conservative

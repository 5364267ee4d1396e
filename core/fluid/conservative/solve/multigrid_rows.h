#pragma once
// Row kernels of the multigrid solver for
//   z x - div(c grad x) = rhs   on a grid of nodes,
// z > 0 the zero-order term, or 0 where there is no node, cx(i,j) the coupling of nodes i and i+1
// of row j, cy(i,j) that of (i,j) and (i,j+1), both >= 0 and scaled by the cell: one row of the
// system is
//   (z + sum c) x_ij - sum c x_neighbour = rhs_ij.
// All pointers point at the first node of a run and may be read one node to each side.
// Source of all: Briggs, Henson, McCormick, A Multigrid Tutorial, SIAM 2000, ch. 3 and 4.

namespace pentimento::conservative {

/// The couplings of a row of nodes.
struct StencilRow {
  const float* cx;        // to the right; cx[-1] to the left
  const float* cy_above;  // of the row above
  const float* cy;        // down
};

/// A row of nodes and its neighbour rows.
struct NodeRow {
  const float* above;
  const float* here;
  const float* below;
};

/// inverse = 1 / (z + sum c), or 0 where z + sum c is 0.
void inverse_diagonal_row(const StencilRow& a, const float* z, int n, float* inverse);

/// One weighted Jacobi sweep.
///   x' = (1 - w) x + w inverse (rhs + sum c x_neighbour)
/// Scheme: Richardson step on the diagonally scaled system; four with the weights of
///   multigrid.cpp make a Chebyshev polynomial of degree 4.
/// Stable: damps every mode for 0 < w < 1; the four together damp all eigenvalues in (0, 2).
/// Source: Adams, Brezina, Hu, Tuminaro, J. Comput. Phys. 188 (2003) 593-610.
/// Departs from it: fixed bounds [1/2, 2] of the spectrum, no estimate.
void smooth_row(const StencilRow& a, const float* inverse, const float* rhs, const NodeRow& x,
                float weight, int n, float* out);

/// inverse_diagonal_row(), and smooth_row() with that: the same bits, and couplings are read once.
void first_smooth_row(const StencilRow& a, const float* z, const float* rhs, const NodeRow& x,
                      float weight, int n, float* inverse, float* out);

/// The same sweep from x = 0: out = w inverse rhs.
void smooth_zero_row(const float* inverse, const float* rhs, float weight, int n, float* out);

/// residual = rhs - z x - sum c (x - x_neighbour).
void residual_row(const StencilRow& a, const float* z, const float* rhs, const NodeRow& x, int n,
                  float* residual);

/// Mean of 2 x 2 nodes: out[i] of n coarse nodes from two fine rows.
void restrict_row(const float* upper, const float* lower, int n, float* out);

/// Coarse couplings: nine tenths of the mean of the two fine couplings that they replace, divided
/// by 4, for the cell is twice as wide. Corrections of a coarser grid fall short of smooth errors;
/// what is coupled less is corrected more. cx joins coarse nodes across fine column 2i+1, cy across
/// fine row 2j+1.
/// Source: Braess, Computing 55 (1995) 379-393.
/// Departs from it: there the factor is 1 / 1.8, for corrections that are the same in a whole
///   coarse cell.
void coarsen_cx_row(const float* upper, const float* lower, int n, float* out);
void coarsen_cy_row(const float* lower, int n, float* out);

/// Adds the interpolated coarse correction to a fine row of n nodes that starts at an even x.
///   x += C/2 + C_beside/4 + C_over/4, neighbours behind a wall (coupling 0) counting as C
/// Scheme: linear on triangles, 2nd order.
/// Stable: a convex combination.
/// Source: Kwak, SIAM J. Sci. Comput. 21 (1999) 552-564.
/// Departs from it: nothing is added where `inverse` is 1, to nodes that are tied to nothing, or 0,
///   where there is no node.
struct ProlongRow {
  const float* coarse;         // the node's own coarse row
  const float* coarse_over;    // the coarse row on the nearer side
  const float* coupling_x;     // coarse cx of the own row
  const float* coupling_over;  // coarse cy between the two coarse rows
};
void prolong_row(const ProlongRow& c, const float* inverse, int n, float* x);

}  // namespace pentimento::conservative

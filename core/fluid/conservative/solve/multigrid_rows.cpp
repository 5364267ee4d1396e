#include "core/fluid/conservative/solve/multigrid_rows.h"

#include "core/base/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void inverse_diagonal_row(const StencilRow& a, const float* __restrict z, int n,
                          float* __restrict inverse) {
  const float* __restrict cx = a.cx;
  const float* __restrict above = a.cy_above;
  const float* __restrict cy = a.cy;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float diagonal = z[i] + ((cx[i - 1] + cx[i]) + (above[i] + cy[i]));
    inverse[i] = diagonal > 0 ? 1 / (diagonal > 0 ? diagonal : 1.0f) : 0.0f;
  }
}

PENTIMENTO_KERNEL
void smooth_row(const StencilRow& a, const float* __restrict inverse, const float* __restrict rhs,
                const NodeRow& x, float weight, int n, float* __restrict out) {
  const float* __restrict cx = a.cx;
  const float* __restrict above = a.cy_above;
  const float* __restrict cy = a.cy;
  const float* __restrict here = x.here;
  const float* __restrict up = x.above;
  const float* __restrict down = x.below;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float sum =
        (cx[i - 1] * here[i - 1] + cx[i] * here[i + 1]) + (above[i] * up[i] + cy[i] * down[i]);
    out[i] = (1 - weight) * here[i] + weight * inverse[i] * (rhs[i] + sum);
  }
}

PENTIMENTO_KERNEL
void first_smooth_row(const StencilRow& a, const float* __restrict z, const float* __restrict rhs,
                      const NodeRow& x, float weight, int n, float* __restrict inverse,
                      float* __restrict out) {
  const float* __restrict cx = a.cx;
  const float* __restrict above = a.cy_above;
  const float* __restrict cy = a.cy;
  const float* __restrict here = x.here;
  const float* __restrict up = x.above;
  const float* __restrict down = x.below;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float diagonal = z[i] + ((cx[i - 1] + cx[i]) + (above[i] + cy[i]));
    const float inverted = diagonal > 0 ? 1 / (diagonal > 0 ? diagonal : 1.0f) : 0.0f;
    const float sum =
        (cx[i - 1] * here[i - 1] + cx[i] * here[i + 1]) + (above[i] * up[i] + cy[i] * down[i]);
    inverse[i] = inverted;
    out[i] = (1 - weight) * here[i] + weight * inverted * (rhs[i] + sum);
  }
}

PENTIMENTO_KERNEL
void smooth_zero_row(const float* __restrict inverse, const float* __restrict rhs, float weight,
                     int n, float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = weight * inverse[i] * rhs[i];
}

PENTIMENTO_KERNEL
void residual_row(const StencilRow& a, const float* __restrict z, const float* __restrict rhs,
                  const NodeRow& x, int n, float* __restrict residual) {
  const float* __restrict cx = a.cx;
  const float* __restrict above = a.cy_above;
  const float* __restrict cy = a.cy;
  const float* __restrict here = x.here;
  const float* __restrict up = x.above;
  const float* __restrict down = x.below;
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) {
    const float flow = (cx[i - 1] * (here[i] - here[i - 1]) + cx[i] * (here[i] - here[i + 1])) +
                       (above[i] * (here[i] - up[i]) + cy[i] * (here[i] - down[i]));
    residual[i] = (rhs[i] - z[i] * here[i]) - flow;
  }
}

PENTIMENTO_KERNEL
void restrict_row(const float* __restrict upper, const float* __restrict lower, int n,
                  float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i)
    out[i] = 0.25f * ((upper[2 * i] + upper[2 * i + 1]) + (lower[2 * i] + lower[2 * i + 1]));
}

namespace {

// The mean of two couplings, a quarter of it, for cells twice as wide, and less by a tenth, which
// halves what cycles leave where couplings are strong (multigrid_test.cpp: 5.6e-4 for 1.1e-3).
constexpr float kOfTwo = 0.5f * 0.25f * 0.9f;

}  // namespace

PENTIMENTO_KERNEL
void coarsen_cx_row(const float* __restrict upper, const float* __restrict lower, int n,
                    float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = kOfTwo * (upper[2 * i + 1] + lower[2 * i + 1]);
}

PENTIMENTO_KERNEL
void coarsen_cy_row(const float* __restrict lower, int n, float* __restrict out) {
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < n; ++i) out[i] = kOfTwo * (lower[2 * i] + lower[2 * i + 1]);
}

namespace {

// One fine node: half of the coarse node over it, a quarter of each nearer neighbour.
inline float corrected(float x, float middle, float beside, float across, float inverse) {
  const float correction = 0.5f * middle + 0.25f * (beside + across);
  const float tied = (inverse > 0 ? 1.0f : 0.0f) * (inverse < 1 ? 1.0f : 0.0f);
  return x + tied * correction;
}

}  // namespace

PENTIMENTO_KERNEL
void prolong_row(const ProlongRow& c, const float* __restrict inverse, int n, float* __restrict x) {
  const float* __restrict coarse = c.coarse;
  const float* __restrict over = c.coarse_over;
  const float* __restrict joined = c.coupling_x;
  const float* __restrict joined_over = c.coupling_over;
  // An odd n writes one node more, whose inverse is 0 and which stays as it is.
  PENTIMENTO_INDEPENDENT
  for (int i = 0; i < (n + 1) / 2; ++i) {
    const float middle = coarse[i];
    const float before = coarse[i - 1];
    const float after = coarse[i + 1];
    const float far = over[i];
    const float left = joined[i - 1] > 0 ? before : middle;
    const float right = joined[i] > 0 ? after : middle;
    const float across = joined_over[i] > 0 ? far : middle;
    x[2 * i] = corrected(x[2 * i], middle, left, across, inverse[2 * i]);
    x[2 * i + 1] = corrected(x[2 * i + 1], middle, right, across, inverse[2 * i + 1]);
  }
}

}  // namespace pentimento::conservative

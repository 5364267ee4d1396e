#include "core/fluid/conservative/multigrid_rows.h"

#include "core/fluid/conservative/kernel.h"

namespace pentimento::conservative {

PENTIMENTO_KERNEL
void inverse_diagonal_row(const StencilRow& a, const float* __restrict z, int n,
                          float* __restrict inverse) {
  const float* __restrict cx = a.cx;
  const float* __restrict above = a.cy_above;
  const float* __restrict cy = a.cy;
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
  for (int i = 0; i < n; ++i) {
    const float sum =
        (cx[i - 1] * here[i - 1] + cx[i] * here[i + 1]) + (above[i] * up[i] + cy[i] * down[i]);
    out[i] = (1 - weight) * here[i] + weight * inverse[i] * (rhs[i] + sum);
  }
}

PENTIMENTO_KERNEL
void smooth_zero_row(const float* __restrict inverse, const float* __restrict rhs, float weight,
                     int n, float* __restrict out) {
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
  for (int i = 0; i < n; ++i) {
    const float flow = (cx[i - 1] * (here[i] - here[i - 1]) + cx[i] * (here[i] - here[i + 1])) +
                       (above[i] * (here[i] - up[i]) + cy[i] * (here[i] - down[i]));
    residual[i] = (rhs[i] - z[i] * here[i]) - flow;
  }
}

PENTIMENTO_KERNEL
void restrict_row(const float* __restrict upper, const float* __restrict lower, int n,
                  float* __restrict out) {
  for (int i = 0; i < n; ++i)
    out[i] = 0.25f * ((upper[2 * i] + upper[2 * i + 1]) + (lower[2 * i] + lower[2 * i + 1]));
}

PENTIMENTO_KERNEL
void coarsen_cx_row(const float* __restrict upper, const float* __restrict lower, int n,
                    float* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = 0.125f * (upper[2 * i + 1] + lower[2 * i + 1]);
}

PENTIMENTO_KERNEL
void coarsen_cy_row(const float* __restrict lower, int n, float* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = 0.125f * (lower[2 * i] + lower[2 * i + 1]);
}

PENTIMENTO_KERNEL
void prolong_row(const ProlongRow& c, const StencilRow& a, int n, float* __restrict x) {
  const float* __restrict coarse = c.coarse;
  const float* __restrict over = c.coarse_over;
  const float* __restrict cx = a.cx;
  const float* __restrict above = a.cy_above;
  const float* __restrict cy = a.cy;
  for (int i = 0; i < n; ++i) {
    const int own = i >> 1;
    const int side = (i & 1) != 0 ? own + 1 : own - 1;
    const float joined = c.coupling_x[(i & 1) != 0 ? own : own - 1];
    const float middle = coarse[own];
    const float beside = joined > 0 ? coarse[side] : middle;
    const float across = c.coupling_over[own] > 0 ? over[own] : middle;
    const bool coupled = (cx[i - 1] + cx[i]) + (above[i] + cy[i]) > 0;
    const float correction = 0.5f * middle + 0.25f * (beside + across);
    x[i] += coupled ? correction : 0.0f;
  }
}

}  // namespace pentimento::conservative

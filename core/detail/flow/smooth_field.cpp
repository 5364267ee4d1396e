#include "core/detail/flow/smooth_field.h"

#include <algorithm>
#include <array>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
/// Taps of fine cell `within`, one of the `factor` cells in a row of a block.
SplineTaps taps_of(int within, int factor) {
  return spline_taps((static_cast<float>(within) + 0.5f) / static_cast<float>(factor) - 0.5f);
}

PENTIMENTO_KERNEL
void combine_rows(const std::array<const float*, 4>& row, const std::array<float, 4>& w, int n,
                  float* __restrict out) {
  const float *a = row[0], *b = row[1], *c = row[2], *d = row[3];
  for (int i = 0; i < n; ++i) out[i] = w[0] * a[i] + w[1] * b[i] + w[2] * c[i] + w[3] * d[i];
}
}  // namespace

TileNeighbourhood::TileNeighbourhood(const CellBox& box, int guide_width, int guide_height)
    : box_(box),
      guide_width_(guide_width),
      guide_height_(guide_height),
      x0_(box.x0 - kMargin),
      y0_(box.y0 - kMargin),
      width_(box.width() + 2 * kMargin),
      height_(box.height() + 2 * kMargin),
      value_(static_cast<std::size_t>(width_ * height_)) {}

void TileNeighbourhood::fill(const std::function<float(int, int)>& value_at) {
  std::size_t i = 0;
  for (int y = y0_; y < y0_ + height_; ++y)
    for (int x = x0_; x < x0_ + width_; ++x)
      value_[i++] =
          value_at(std::clamp(x, 0, guide_width_ - 1), std::clamp(y, 0, guide_height_ - 1));
}

void TileNeighbourhood::smooth(int factor, float* out, std::ptrdiff_t stride) const {
  const int cells = box_.width() * factor;
  std::vector<SplineTaps> phase;
  for (int i = 0; i < factor; ++i) phase.push_back(taps_of(i, factor));
  // Along the rows first: each row of the guide gets its fine columns.
  std::vector<float> stretched(static_cast<std::size_t>(cells) * static_cast<std::size_t>(height_));
  for (int y = 0; y < height_; ++y) {
    float* to = stretched.data() + static_cast<std::ptrdiff_t>(y) * cells;
    const float* v = value_.data() + y * width_ + kMargin;
    for (int x = 0; x < box_.width(); ++x, ++v)
      for (const SplineTaps& p : phase) {
        const float* near = v + p.first;
        *to++ = p.weight[0] * near[0] + p.weight[1] * near[1] + p.weight[2] * near[2] +
                p.weight[3] * near[3];
      }
  }
  // Then down: each fine row is a mean of four of those.
  for (int y = 0; y < box_.height() * factor; ++y) {
    const SplineTaps& p = phase[static_cast<std::size_t>(y % factor)];
    const float* first =
        stretched.data() + static_cast<std::ptrdiff_t>(y / factor + kMargin + p.first) * cells;
    combine_rows({first, first + cells, first + 2 * cells, first + 3 * cells}, p.weight, cells,
                 out + y * stride);
  }
}

}  // namespace pentimento

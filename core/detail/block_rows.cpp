#include "core/detail/block_rows.h"

#include <algorithm>

#include "core/fluid/conservative/kernel.h"

namespace pentimento {

namespace {
/// The two cells a position between centres lies between, and how far.
struct Between {
  int low = 0, high = 0;
  float share = 0;
};

Between between(int fine, int factor, int cells) {
  const float at = (static_cast<float>(fine) + 0.5f) / static_cast<float>(factor) - 0.5f;
  const int low = at < 0 ? -1 : static_cast<int>(at);
  return {std::max(low, 0), std::min(low + 1, cells - 1), at - static_cast<float>(low)};
}

PENTIMENTO_KERNEL
void multiply_between(const float* __restrict a, const float* __restrict b, float t, int n,
                      float* __restrict value) {
  for (int i = 0; i < n; ++i) value[i] *= a[i] + t * (b[i] - a[i]);
}
}  // namespace

PENTIMENTO_KERNEL
void block_means(const float* plane, int side, int factor, const GuideBox& box,
                 std::span<float> mean) {
  const int width = box.width();
  std::vector<double> sum(static_cast<std::size_t>(width));
  const double per_block = 1.0 / (static_cast<double>(factor) * factor);
  for (int j = 0; j < box.height(); ++j) {
    std::fill(sum.begin(), sum.end(), 0.0);
    for (int y = 0; y < factor; ++y) {
      const float* row = plane + static_cast<std::ptrdiff_t>(j * factor + y) * side;
      for (int i = 0; i < width; ++i, row += factor) {
        float part = 0;
        for (int x = 0; x < factor; ++x) part += row[x];
        sum[static_cast<std::size_t>(i)] += static_cast<double>(part);
      }
    }
    for (int i = 0; i < width; ++i)
      mean[static_cast<std::size_t>(j * width + i)] =
          static_cast<float>(sum[static_cast<std::size_t>(i)] * per_block);
  }
}

void scale_by_field(FieldView<const float> ratio, int factor, const GuideBox& box, float* plane,
                    int side) {
  const int cells = box.width() * factor;
  std::vector<Between> column(static_cast<std::size_t>(cells));
  for (int x = 0; x < cells; ++x)
    column[static_cast<std::size_t>(x)] = between(box.x0 * factor + x, factor, ratio.width());
  const auto stretch = [&](int row, std::vector<float>& out) {
    out.resize(static_cast<std::size_t>(cells));
    const float* r = ratio.row(row);
    for (std::size_t x = 0; x < out.size(); ++x)
      out[x] = r[column[x].low] + column[x].share * (r[column[x].high] - r[column[x].low]);
  };
  std::vector<float> low, high;
  int low_row = -1, high_row = -1;
  for (int y = 0; y < box.height() * factor; ++y) {
    const Between row = between(box.y0 * factor + y, factor, ratio.height());
    if (row.low != low_row) stretch(low_row = row.low, low);
    if (row.high != high_row) stretch(high_row = row.high, high);
    multiply_between(low.data(), high.data(), row.share, cells,
                     plane + static_cast<std::ptrdiff_t>(y) * side);
  }
}

void scale_blocks(std::span<const float> scale, int factor, const GuideBox& box, float* plane,
                  int side) {
  for (int y = 0; y < box.height() * factor; ++y) {
    float* row = plane + static_cast<std::ptrdiff_t>(y) * side;
    const float* by = scale.data() + static_cast<std::ptrdiff_t>(y / factor) * box.width();
    for (int i = 0; i < box.width(); ++i, row += factor) {
      if (by[i] == 1) continue;
      for (int x = 0; x < factor; ++x) row[x] *= by[i];
    }
  }
}

}  // namespace pentimento

#include "core/detail/store/block_rows.h"

#include <algorithm>
#include <array>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
using TileRowBuffer = std::array<float, kMostTileSide>;

PENTIMENTO_KERNEL
void add_rows(const float* value, std::ptrdiff_t stride, int rows, int n, float* __restrict sum) {
  for (int y = 0; y < rows; ++y, value += stride)
    for (int i = 0; i < n; ++i) sum[i] += value[i];
}

PENTIMENTO_KERNEL
void multiply_rows(const float* __restrict by, int rows, int n, float* __restrict value,
                   std::ptrdiff_t stride) {
  for (int y = 0; y < rows; ++y, value += stride)
    for (int i = 0; i < n; ++i) value[i] *= by[i];
}

/// The rows between the centres of the rows of blocks that a and b belong to, `share` from a to b.
PENTIMENTO_KERNEL
void multiply_between(const float* __restrict a, const float* __restrict b, const float* share,
                      int rows, int n, float* __restrict value, std::ptrdiff_t stride,
                      float* __restrict sum) {
  for (int y = 0; y < rows; ++y, value += stride) {
    const float t = share[y];
    for (int i = 0; i < n; ++i) {
      const float scaled = value[i] * (a[i] + t * (b[i] - a[i]));
      value[i] = scaled;
      sum[i] += scaled;
    }
  }
}

/// How far the centre of fine cell `i` of a block lies from the lower of the two guide centres
/// around it; the cells before the middle have the block's own centre as their upper one.
float share_of(int i, int factor) {
  const float at = (static_cast<float>(i) + 0.5f) / static_cast<float>(factor) - 0.5f;
  return at < 0 ? at + 1 : at;
}

/// A row of the interpolated field, at the fine columns of the blocks.
void stretch(const float* ratio, const BlockRow& row, const TileRowBuffer& share,
             TileRowBuffer& out) {
  const int k = row.factor, half = k / 2;
  float* to = out.data();
  for (int i = 0; i < row.blocks; ++i, to += k) {
    const float before = ratio[i - 1], here = ratio[i], after = ratio[i + 1];
    for (int j = 0; j < half; ++j)
      to[j] = before + share[static_cast<std::size_t>(j)] * (here - before);
    for (int j = half; j < k; ++j)
      to[j] = here + share[static_cast<std::size_t>(j)] * (after - here);
  }
}

void means_of(const TileRowBuffer& sum, const BlockRow& row, std::span<float> mean) {
  const double per_block = 1.0 / (static_cast<double>(row.factor) * row.factor);
  const float* column = sum.data();
  for (int i = 0; i < row.blocks; ++i, column += row.factor) {
    double total = 0;
    for (int x = 0; x < row.factor; ++x) total += static_cast<double>(column[x]);
    mean[static_cast<std::size_t>(i)] = static_cast<float>(total * per_block);
  }
}
}  // namespace

BlockRow block_row(float* plane, const DetailLayout& layout, const BlockStrip& strip) {
  const int k = layout.factor(), side = layout.side(), blocks = layout.blocks();
  const std::ptrdiff_t row = static_cast<std::ptrdiff_t>(strip.y % blocks) * k * side;
  return {plane + row + strip.x0 % blocks * k, side, k, strip.blocks()};
}

void read_around(const Field<float>& plane, const BlockStrip& strip, RatiosAround& out) {
  for (int row = 0; row < 3; ++row) {
    const float* value = plane.row(std::clamp(strip.y + row - 1, 0, plane.height() - 1));
    for (int block = -1; block <= strip.blocks(); ++block)
      out.at(row, block) = value[std::clamp(strip.x0 + block, 0, plane.width() - 1)];
  }
}

void block_means(const BlockRow& row, std::span<float> mean) {
  TileRowBuffer sum;
  std::fill_n(sum.begin(), row.cells(), 0.0f);
  add_rows(row.first, row.stride, row.factor, row.cells(), sum.data());
  means_of(sum, row, mean);
}

void scale_by_field(const RatioRows& ratio, const BlockRow& row, std::span<float> mean) {
  const int k = row.factor, half = k / 2, n = row.cells();
  TileRowBuffer share, above, here, below, sum;
  for (int i = 0; i < k; ++i) share[static_cast<std::size_t>(i)] = share_of(i, k);
  stretch(ratio.above, row, share, above);
  stretch(ratio.here, row, share, here);
  stretch(ratio.below, row, share, below);
  std::fill_n(sum.begin(), n, 0.0f);
  multiply_between(above.data(), here.data(), share.data(), half, n, row.first, row.stride,
                   sum.data());
  multiply_between(here.data(), below.data(), share.data() + half, k - half, n,
                   row.first + half * row.stride, row.stride, sum.data());
  means_of(sum, row, mean);
}

void scale_blocks(std::span<const float> scale, const BlockRow& row) {
  TileRowBuffer by;
  for (int i = 0; i < row.blocks; ++i)
    std::fill_n(by.begin() + i * row.factor, row.factor, scale[static_cast<std::size_t>(i)]);
  multiply_rows(by.data(), row.factor, row.cells(), row.first, row.stride);
}

}  // namespace pentimento

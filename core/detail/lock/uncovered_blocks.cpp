#include "core/detail/lock/uncovered_blocks.h"

#include <algorithm>

namespace pentimento {

namespace {
/// The fine cell (x, y) of the whole canvas, or 0 where there is none.
float cell_at(DetailCanvas& canvas, const WetPlane& q, int x, int y) {
  const DetailLayout& layout = canvas.layout();
  const int side = layout.side();
  if (x < 0 || y < 0 || x >= layout.guide().width * layout.factor() ||
      y >= layout.guide().height * layout.factor())
    return 0;
  DetailTile* tile = canvas.find(layout.tile_of(x / side, y / side));
  if (tile == nullptr || !q.of(*tile)) return 0;
  return q.of(*tile).data()[static_cast<std::ptrdiff_t>(y % side) * side + x % side];
}

float mean_of(const std::vector<float>& weight) {
  double sum = 0;
  for (const float w : weight) sum += static_cast<double>(w);
  return static_cast<float>(sum / static_cast<double>(weight.size()));
}
/// weight = depth * weight, or the depth alone where nothing has a weight.
void weigh_by_depth(DetailCanvas& canvas, const UncoveredBlock& block, int k,
                    std::vector<float>& weight) {
  constexpr float kEverywhere = 1.0f / 30;
  const WetPlane depth;
  const float mean = mean_of(weight);
  const float least = mean > 0 ? kEverywhere * mean : 1.0f;
  for (int y = 0; y < k; ++y)
    for (int x = 0; x < k; ++x)
      weight[static_cast<std::size_t>(y * k + x)] =
          (weight[static_cast<std::size_t>(y * k + x)] + least) *
          cell_at(canvas, depth, block.x * k + x, block.y * k + y);
}

void add_extension(DetailCanvas& canvas, const WetPlane& q, const UncoveredBlock& block, int k,
                   std::vector<float>& weight) {
  const int x0 = block.x * k, y0 = block.y * k;
  const auto fade = [&](int distance) {
    const float f = 1 - (static_cast<float>(distance) + 0.5f) / static_cast<float>(k);
    return f * f;
  };
  for (int i = 0; i < k; ++i) {
    const float left = cell_at(canvas, q, x0 - 1, y0 + i),
                right = cell_at(canvas, q, x0 + k, y0 + i);
    const float above = cell_at(canvas, q, x0 + i, y0 - 1),
                below = cell_at(canvas, q, x0 + i, y0 + k);
    for (int d = 0; d < k; ++d) {
      weight[static_cast<std::size_t>(i * k + d)] += left * fade(d) + right * fade(k - 1 - d);
      weight[static_cast<std::size_t>(d * k + i)] += above * fade(d) + below * fade(k - 1 - d);
    }
  }
}

}  // namespace

void fill_uncovered(DetailCanvas& canvas, const WetPlane& q, UncoveredBlock& block) {
  const int k = canvas.layout().factor();
  block.value.assign(static_cast<std::size_t>(k) * static_cast<std::size_t>(k), 0.0f);
  add_extension(canvas, q, block, k, block.value);
  if (q.pigment >= 0) {
    weigh_by_depth(canvas, block, k, block.value);
    if (!(mean_of(block.value) > 0)) add_extension(canvas, q, block, k, block.value);
  }
  const float mean = mean_of(block.value);
  if (!(mean > 0)) {
    std::fill(block.value.begin(), block.value.end(), block.mean);
    return;
  }
  for (float& w : block.value) w = w / mean * block.mean;
}

void store_uncovered(DetailCanvas& canvas, const WetPlane& q, const UncoveredBlock& block) {
  const DetailLayout& layout = canvas.layout();
  const int k = layout.factor(), blocks = layout.blocks();
  DetailTile* tile = canvas.find(layout.tile_of(block.x / blocks, block.y / blocks));
  float* data = q.of(*tile).data();
  for (int y = 0; y < k; ++y)
    std::copy_n(block.value.data() + static_cast<std::ptrdiff_t>(y) * k, k,
                data + static_cast<std::ptrdiff_t>(block.y % blocks * k + y) * layout.side() +
                    block.x % blocks * k);
}

}  // namespace pentimento

#include "core/detail/fine_remap.h"

#include "core/fluid/conservative/limiter.h"

namespace pentimento {

void find_sources(std::span<const float> position, FineSources& sources) {
  const std::size_t edges = position.size();
  sources.cell.resize(edges);
  sources.share.resize(edges);
  std::size_t i = 0;
  for (std::size_t j = 0; j + 1 < edges; ++j) {
    const float at = static_cast<float>(j);
    while (i + 2 < edges && position[i + 1] <= at) ++i;
    const float share = (at - position[i]) / (position[i + 1] - position[i]);
    sources.cell[j] = static_cast<int>(i);
    sources.share[j] = share < 0 ? 0.0f : share > 1 ? 1.0f : share;
  }
  sources.cell[edges - 1] = static_cast<int>(edges) - 2;
  sources.share[edges - 1] = 1;
}

void remap_line(const FineSources& sources, std::span<const float> amount, std::span<float> part,
                std::span<float> out) {
  const float* m = amount.data() + 1;
  const std::size_t edges = out.size() + 1;
  for (std::size_t j = 0; j < edges; ++j) {
    const int i = sources.cell[j];
    const float s = sources.share[j];
    const float slope = conservative::limited_mc(m[i] - m[i - 1], m[i + 1] - m[i]);
    part[j] = s * (m[i] - 0.5f * slope * (1 - s));
  }
  for (std::size_t j = 0; j + 1 < edges; ++j) {
    float sum = part[j + 1] - part[j];
    for (int i = sources.cell[j]; i < sources.cell[j + 1]; ++i) sum += m[i];
    out[j] = sum > 0 ? sum : 0.0f;
  }
}

}  // namespace pentimento

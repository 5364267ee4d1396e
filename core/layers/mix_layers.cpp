#include "core/layers/mix_layers.h"

#include <algorithm>

namespace pentimento {

namespace {
void mix_cell(const LayerRow& row, int x, float m, float residue) {
  const int top = row.top(x);
  if (top < 1) return;
  const float total = row.total(0, x);
  const float mobile = total > residue ? (total - residue) / total : 0.0f;
  for (int c = 0; c < row.channels; ++c) {
    float below = mobile * row.at(0, c, x);
    float incoming = 0;  // into layer k from below
    for (int k = 0; k < top; ++k) {
      const float above = row.at(k + 1, c, x);
      const float outgoing = m * (below - above);
      row.at(k, c, x) += incoming - outgoing;
      incoming = outgoing;
      below = above;
    }
    row.at(top, c, x) += incoming;
  }
}
}  // namespace

void mix_layers_row(const MixLayers& mix, const LayerRow& row, std::span<const float> weight) {
  if (row.layers < 2) return;
  for (std::size_t i = 0; i < weight.size(); ++i) {
    const float m = std::min(0.5f, mix.exchange_frac * weight[i]);
    if (m > 0) mix_cell(row, static_cast<int>(i), m, mix.residue);
  }
}

}  // namespace pentimento

#include "core/brush/collect_paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/kernel.h"

namespace pentimento {

namespace {
constexpr float kFineCell = 1.25f;  // texels: up to this, four texels take a cell's paint evenly

/// Weights of the texels near one place along one axis: a tent of half width `half` about it. They
/// are 0 outside of [begin, end).
template <int kCount>
struct Tent {
  int begin = 0, end = 0;
  std::array<float, kCount> weight;

  Tent(float at, float half) {
    begin = static_cast<int>(std::clamp(at - half + 1, 0.0f, static_cast<float>(kCount)));
    end = static_cast<int>(std::clamp(std::ceil(at + half), 0.0f, static_cast<float>(kCount)));
    for (int i = 0; i < kCount; ++i) {
      const float tent = std::max(0.0f, 1 - std::abs(static_cast<float>(i) - at) / half);
      weight[static_cast<std::size_t>(i)] = i >= begin && i < end ? tent : 0.0f;
    }
  }
  float operator[](int i) const { return weight[static_cast<std::size_t>(i)]; }
};

using Across = Tent<kReservoirRows>;
using AlongTent = Tent<kReservoirColumns>;

/// The sum of the weights of those texels that the tip covers. Each row's sum goes along the row.
inline float covered_weight(const AlongTent& along, const Across& across,
                            const CoveredTexels& covered) {
  std::array<float, kReservoirRows> row{};
  for (int i = along.begin; i < along.end; ++i) {
    const float* column = covered.by_column.data() + std::ptrdiff_t{kReservoirRows} * i;
    for (int j = 0; j < kReservoirRows; ++j)
      row[static_cast<std::size_t>(j)] += along[i] * column[j];
  }
  float total = 0;
  for (int j = across.begin; j < across.end; ++j)
    total += across[j] * row[static_cast<std::size_t>(j)];
  return total;
}

void give(const float* paint, float factor, int stride, float* __restrict out) {
  for (int k = 0; k < stride; k += 4)
    for (int i = k; i < k + 4; ++i) out[i] += factor * paint[i];
}

bool is_nothing(const float* paint, int stride) {
  for (int k = 0; k < stride; ++k)
    if (paint[k] != 0) return false;
  return true;
}

/// Gives a cell's paint to the four texels around it, with the weights of a sample there. False if
/// the tip covers none of them.
bool give_to_four(const float* paint, float factor, Vec2f at, const Tip& tip,
                  Reservoir& reservoir) {
  const float x = std::clamp(at.x, 0.0f, kReservoirColumns - 1.0f);
  const float y = std::clamp(at.y, 0.0f, kReservoirRows - 1.0f);
  const int i = std::min(static_cast<int>(x), kReservoirColumns - 2);
  const int j = std::min(static_cast<int>(y), kReservoirRows - 2);
  const float fx = x - static_cast<float>(i), fy = y - static_cast<float>(j);
  const int a = j * kReservoirColumns + i, c = a + kReservoirColumns;
  const float* covered = tip.covered().by_row.data();
  const std::array<float, 4> w = {(1 - fx) * (1 - fy) * covered[a], fx * (1 - fy) * covered[a + 1],
                                  (1 - fx) * fy * covered[c], fx * fy * covered[c + 1]};
  const float total = (w[0] + w[1]) + (w[2] + w[3]);
  if (!(total > 0)) return false;
  const float scale = factor / total;
  const int stride = reservoir.stride();
  float* top = reservoir.dirty_texel(a);
  give(paint, scale * w[0], stride, top);
  give(paint, scale * w[1], stride, top + stride);
  float* bottom = reservoir.dirty_texel(c);
  give(paint, scale * w[2], stride, bottom);
  give(paint, scale * w[3], stride, bottom + stride);
  return true;
}

struct TentPlace {
  float at = 0, half = 1;
};

/// Gives the paint of a cell wider than a texel to all texels that it reaches. False if the tip
/// covers none of them.
bool give_to_tents(const float* paint, float factor, TentPlace u, TentPlace v, const Tip& tip,
                   Reservoir& reservoir) {
  const AlongTent along(u.at, u.half);
  const Across across(v.at, v.half);
  const float weight = covered_weight(along, across, tip.covered());
  if (!(weight > 0)) return false;
  for (int j = across.begin; j < across.end; ++j) {
    const float share = factor / weight * across[j];
    for (int i = along.begin; i < along.end; ++i) {
      const int texel = j * kReservoirColumns + i;
      const float w = share * along[i] * tip.covered().by_row[static_cast<std::size_t>(texel)];
      if (w > 0) give(paint, w, reservoir.stride(), reservoir.dirty_texel(texel));
    }
  }
  return true;
}

/// The same for texels of four floats, as most brushes have them: four texels at a time. Those
/// that are not reached are given nothing, which is quicker than to ask. `texels`: all of them.
PENTIMENTO_KERNEL
bool give_four_to_tents(const float* paint, float factor, TentPlace u, TentPlace v,
                        const CoveredTexels& covered, float* __restrict texels) {
  constexpr int kFour = 4, kTogether = kFour * kFour, kRow = kFour * kReservoirColumns;
  const AlongTent along(u.at, u.half);
  const Across across(v.at, v.half);
  const float weight = covered_weight(along, across, covered);
  if (!(weight > 0)) return false;
  std::array<float, kRow> weights;
  std::array<float, kTogether> paints;
  for (int i = 0; i < kRow; ++i) weights[static_cast<std::size_t>(i)] = along[i / kFour];
  for (int i = 0; i < kTogether; ++i) paints[static_cast<std::size_t>(i)] = paint[i % kFour];
  for (int j = across.begin; j < across.end; ++j) {
    const float share = factor / weight * across[j];
    for (int i = along.begin / kFour * kTogether; i < along.end * kFour; i += kTogether) {
      const float* w = weights.data() + i;
      const float* is_covered = covered.four.data() + std::ptrdiff_t{kRow} * j + i;
      float* __restrict texel = texels + std::ptrdiff_t{kRow} * j + i;
      for (int k = 0; k < kTogether; ++k)
        texel[k] += share * w[k] * is_covered[k] * paints[static_cast<std::size_t>(k)];
    }
  }
  return true;
}

bool give_to_wide(const float* paint, float factor, TentPlace u, TentPlace v, const Tip& tip,
                  Reservoir& reservoir) {
  if (reservoir.stride() != 4) return give_to_tents(paint, factor, u, v, tip, reservoir);
  return give_four_to_tents(paint, factor, u, v, tip.covered(), reservoir.dirty_texel(0));
}

/// Spreads the paint that reached no texel evenly.
void spread(std::span<const float> paint, const Tip& tip, Reservoir& reservoir) {
  const float share = 1 / static_cast<float>(tip.texels().size());
  for (const TipTexel& t : tip.texels())
    give(paint.data(), share, static_cast<int>(paint.size()), reservoir.dirty_texel(t.index));
}
}  // namespace

void collect_picked_up(const PickedUpPaint& picked_up, const TipPose& pose, const FootprintBox& box,
                       const CanvasGeometry& geometry, const Tip& tip, Reservoir& reservoir) {
  const int stride = picked_up.stride;
  const float dx = geometry.dx_m(), dy = geometry.dy_m();
  // A cell's size in texels.
  const auto size = [&](float by_x, float by_y, int texels) {
    const float x = by_x * dx, y = by_y * dy;
    return static_cast<float>(texels) * std::sqrt(x * x + y * y);
  };
  const float size_u = size(pose.u_x, pose.u_y, kReservoirColumns);
  const float size_v = size(pose.v_x, pose.v_y, kReservoirRows);
  const bool fine = size_u <= kFineCell && size_v <= kFineCell;
  const double tip_area =
      static_cast<double>(pose.diameter_m) * static_cast<double>(pose.diameter_m);
  const float cells_per_texel =
      static_cast<float>(geometry.cell_area_m2() * kReservoirTexels / tip_area);
  std::vector<float> unreached;
  for (int y = 0; y < box.height; ++y) {
    const TipRow row = tip_row(pose, box, geometry, box.y + y);
    const TouchedCells& cells = picked_up.rows[static_cast<std::size_t>(y)];
    const float* paint = picked_up.paint.data() + cells.at * static_cast<std::size_t>(stride);
    for (int x = cells.begin; x < cells.end; ++x, paint += stride) {
      if (is_nothing(paint, stride)) continue;
      const float at_u = (row.u(x) + 0.5f) * kReservoirColumns - 0.5f;
      const float at_v = (row.v(x) + 0.5f) * kReservoirRows - 0.5f;
      const bool given = fine ? give_to_four(paint, cells_per_texel, {at_u, at_v}, tip, reservoir)
                              : give_to_wide(paint, cells_per_texel, {at_u, std::max(1.0f, size_u)},
                                             {at_v, std::max(1.0f, size_v)}, tip, reservoir);
      if (given) continue;
      unreached.resize(static_cast<std::size_t>(stride), 0.0f);
      give(paint, cells_per_texel, stride, unreached.data());
    }
  }
  if (!unreached.empty()) spread(unreached, tip, reservoir);
}

}  // namespace pentimento

#include "core/brush/collect_paint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "core/base/four.h"
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

using RowWeights = std::array<float, kReservoirColumns>;

struct TentPlace {
  float at = 0, half = 1;
};

// Floats that are added at a time.
using EightFloats = float __attribute__((vector_size(32)));

/// texel += w paint for the texels [begin, end) of a row. A texel is `chunks` vectors, or kChunks
/// where that is not 0.
template <typename Chunk, int kChunks>
inline void give_to_row(const float* paint, const RowWeights& w, int begin, int end, int chunks,
                        float* texels) {
  constexpr std::ptrdiff_t kFloats = sizeof(Chunk) / sizeof(float);
  const int count = kChunks > 0 ? kChunks : chunks;
  float* out = texels + static_cast<std::ptrdiff_t>(begin) * count * kFloats;
  for (int i = begin; i < end; ++i) {
    const float weight = w[static_cast<std::size_t>(i)];
    for (int k = 0; k < count; ++k, out += kFloats) {
      Chunk given, texel;
      std::memcpy(&given, paint + kFloats * k, sizeof given);
      std::memcpy(&texel, out, sizeof texel);
      texel += weight * given;
      std::memcpy(out, &texel, sizeof texel);
    }
  }
}

/// A cell wider than a texel, and the texels that it reaches. `weight`: the sum of their weights.
struct WideCell {
  const float* paint;
  float factor, weight;
  const AlongTent& along;
  const Across& across;
};

/// Gives the cell's paint to the texels that it reaches. Those that the tip does not cover are
/// given nothing, which is quicker than to ask.
template <typename Chunk, int kChunks>
inline void give_to_rows(const WideCell& cell, const CoveredTexels& covered, int stride,
                         float* texels) {
  for (int j = cell.across.begin; j < cell.across.end; ++j) {
    const float share = cell.factor / cell.weight * cell.across[j];
    const float* is_covered = covered.by_row.data() + std::ptrdiff_t{kReservoirColumns} * j;
    RowWeights w;
    for (int i = 0; i < kReservoirColumns; ++i)
      w[static_cast<std::size_t>(i)] = share * cell.along[i] * is_covered[i];
    give_to_row<Chunk, kChunks>(
        cell.paint, w, cell.along.begin, cell.along.end,
        stride / static_cast<int>(sizeof(Chunk) / sizeof(float)),
        texels + static_cast<std::ptrdiff_t>(j) * kReservoirColumns * stride);
  }
}

/// Gives the paint of a cell wider than a texel to all texels that it reaches. A texel has `stride`
/// floats, and all texels are at `texels`. False if the tip covers none that the cell reaches.
PENTIMENTO_KERNEL
bool give_to_tents(const float* paint, float factor, TentPlace u, TentPlace v,
                   const CoveredTexels& covered, int stride, float* texels) {
  const AlongTent along(u.at, u.half);
  const Across across(v.at, v.half);
  const float weight = covered_weight(along, across, covered);
  if (!(weight > 0)) return false;
  const WideCell cell{paint, factor, weight, along, across};
  // Loops of their own for up to seven pigments; beyond, to know the number gains nothing.
  if (stride == 4) {
    give_to_rows<Four, 1>(cell, covered, stride, texels);
  } else if (stride == 8) {
    give_to_rows<EightFloats, 1>(cell, covered, stride, texels);
  } else {
    give_to_rows<Four, 0>(cell, covered, stride, texels);
  }
  return true;
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
      const bool given = fine
                             ? give_to_four(paint, cells_per_texel, {at_u, at_v}, tip, reservoir)
                             : give_to_tents(paint, cells_per_texel, {at_u, std::max(1.0f, size_u)},
                                             {at_v, std::max(1.0f, size_v)}, tip.covered(), stride,
                                             reservoir.dirty_texel(0));
      if (given) continue;
      unreached.resize(static_cast<std::size_t>(stride), 0.0f);
      give(paint, cells_per_texel, stride, unreached.data());
    }
  }
  if (!unreached.empty()) spread(unreached, tip, reservoir);
}

}  // namespace pentimento

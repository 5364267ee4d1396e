#include "core/detail/flow/surface_spline.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/detail/flow/smooth_field.h"

namespace pentimento {
namespace {
constexpr int kRounds = 2;
constexpr int kMeanReach = 2;  // of M, in cells
constexpr std::array<float, 5> kMean = {1 / 384.0f, 76 / 384.0f, 230 / 384.0f, 76 / 384.0f,
                                        1 / 384.0f};

/// M v at a cell that has kMeanReach cells on every side.
float mean_of_spline(const Field<float>& v, int x, int y) {
  float sum = 0;
  for (int j = -kMeanReach; j <= kMeanReach; ++j) {
    const float* row = v.row(y + j) + x;
    float along = 0;
    for (int i = -kMeanReach; i <= kMeanReach; ++i)
      along += kMean[static_cast<std::size_t>(i + kMeanReach)] * row[i];
    sum += kMean[static_cast<std::size_t>(j + kMeanReach)] * along;
  }
  return sum;
}
}  // namespace

Field<float> surface_spline(const CanvasState& guide, const CellBox& box, int factor) {
  constexpr int kMargin = TileNeighbourhood::kMargin + kRounds * kMeanReach;
  const int x0 = box.x0 - kMargin, y0 = box.y0 - kMargin;
  // Heights around the box; beyond the canvas the outermost cells repeat.
  Field<float> height(box.width() + 2 * kMargin, box.height() + 2 * kMargin);
  for (int y = 0; y < height.height(); ++y) {
    const int v = std::clamp(y0 + y, 0, guide.geometry.height - 1);
    for (int x = 0; x < height.width(); ++x) {
      const int u = std::clamp(x0 + x, 0, guide.geometry.width - 1);
      height(x, y) = guide.base_m(u, v) + guide.depth_m(u, v);
    }
  }
  Field<float> coefficient = height.clone(), next = height.clone();
  for (int margin = kMeanReach; margin <= kRounds * kMeanReach; margin += kMeanReach) {
    for (int y = margin; y < height.height() - margin; ++y)
      for (int x = margin; x < height.width() - margin; ++x)
        next(x, y) = coefficient(x, y) + height(x, y) - mean_of_spline(coefficient, x, y);
    swap(coefficient, next);
  }
  // A box that reaches beyond the canvas is of no use to TileNeighbourhood, so it lies inside.
  TileNeighbourhood values(box, guide.geometry.width, guide.geometry.height);
  values.fill([&](int x, int y) { return coefficient(x - x0, y - y0); });
  Field<float> out(box.width() * factor, box.height() * factor);
  values.smooth(factor, out.row(0), out.view().stride());
  return out;
}

}  // namespace pentimento

#include "core/brush/collect_paint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/brush/builtin_brushes.h"

namespace pentimento {
namespace {

/// A stamp of a flat tip that lies askew, on cells of which `across` make up its diameter, and
/// paint on all of them.
struct PaintedStamp {
  BrushDefinition brush = *builtin_brush("flat");
  Tip tip{brush};
  CanvasGeometry geometry{100, 75, 0.2, 0.15};
  TipPose pose;
  FootprintBox box;
  std::vector<TouchedCells> rows;
  std::vector<float> paint;

  PaintedStamp(float across, int channels, int stride) {
    Stamp stamp;
    stamp.x_m = 0.1;
    stamp.y_m = 0.07;
    stamp.diameter_m = across * 0.002f;
    stamp.direction = {0.8f, 0.6f};
    pose = pose_of(stamp, brush, 0);
    box = box_of(pose, tip.extent(), geometry);
    for (int y = 0; y < box.height; ++y)
      rows.push_back({0, box.width, static_cast<std::size_t>(y * box.width)});
    for (int i = 0; i < box.width * box.height; ++i)
      for (int k = 0; k < stride; ++k)
        paint.push_back(k <= channels ? 1e-3f * static_cast<float>((i * 7 + k * 5) % 13) : 0.0f);
  }
};

float tent(int texel, float at, float half) {
  return std::max(0.0f, 1 - std::abs(static_cast<float>(texel) - at) / half);
}

float length(float x, float y) {
  return std::sqrt(x * x + y * y);
}

/// The same, texel by texel: each cell's paint is divided by the weights of the covered texels that
/// its tents reach, and paint that reaches none among all of the tip's.
void collect_plainly(const PaintedStamp& s, Reservoir& reservoir) {
  const int stride = reservoir.stride();
  const float dx = s.geometry.dx_m(), dy = s.geometry.dy_m();
  const float half_u = std::max(1.0f, kReservoirColumns * length(s.pose.u_x * dx, s.pose.u_y * dy));
  const float half_v = std::max(1.0f, kReservoirRows * length(s.pose.v_x * dx, s.pose.v_y * dy));
  const float cells_per_texel = static_cast<float>(
      s.geometry.cell_area_m2() * kReservoirTexels /
      (static_cast<double>(s.pose.diameter_m) * static_cast<double>(s.pose.diameter_m)));
  std::vector<float> unreached(static_cast<std::size_t>(stride), 0.0f);
  for (int y = 0; y < s.box.height; ++y) {
    const TipRow row = tip_row(s.pose, s.box, s.geometry, s.box.y + y);
    for (int x = 0; x < s.box.width; ++x) {
      const float* paint = s.paint.data() + (y * s.box.width + x) * stride;
      const float u = (row.u(x) + 0.5f) * kReservoirColumns - 0.5f;
      const float v = (row.v(x) + 0.5f) * kReservoirRows - 0.5f;
      const auto covers = [&](int i, int j) {
        return s.tip.covered().by_row[static_cast<std::size_t>(j * kReservoirColumns + i)];
      };
      float weight = 0;
      for (int j = 0; j < kReservoirRows; ++j) {
        float sum = 0;
        for (int i = 0; i < kReservoirColumns; ++i) sum += tent(i, u, half_u) * covers(i, j);
        weight += tent(j, v, half_v) * sum;
      }
      for (std::size_t k = 0; !(weight > 0) && k < unreached.size(); ++k)
        unreached[k] += cells_per_texel * paint[k];
      for (int j = 0; weight > 0 && j < kReservoirRows; ++j) {
        const float share = cells_per_texel / weight * tent(j, v, half_v);
        for (int i = 0; i < kReservoirColumns; ++i) {
          const float w = share * tent(i, u, half_u) * covers(i, j);
          float* texel = reservoir.dirty_texel(j * kReservoirColumns + i);
          for (int k = 0; k < stride; ++k) texel[k] += w * paint[k];
        }
      }
    }
  }
  for (const TipTexel& t : s.tip.texels())
    for (std::size_t k = 0; k < unreached.size(); ++k)
      reservoir.dirty_texel(t.index)[k] +=
          1 / static_cast<float>(s.tip.texels().size()) * unreached[k];
}

TEST(CollectPaint, WideCellsGiveWhatTheyGiveTexelByTexel) {
  // Texels of 4, 8, 12, 16, 20 and 24 floats; the first two have loops of their own.
  for (const int channels : {2, 7, 11, 15, 19, 22}) {
    for (const float across : {3.0f, 7.0f}) {
      Reservoir fast(channels), plain(channels);
      const PaintedStamp stamp(across, channels, fast.stride());
      collect_picked_up({stamp.paint, fast.stride(), stamp.rows}, stamp.pose, stamp.box,
                        stamp.geometry, stamp.tip, fast);
      collect_plainly(stamp, plain);
      for (int t = 0; t < kReservoirTexels; ++t)
        for (int k = 0; k < fast.stride(); ++k)
          ASSERT_EQ(fast.texel(t)[k], plain.texel(t)[k]) << channels << " " << t << " " << k;
    }
  }
}

}  // namespace
}  // namespace pentimento

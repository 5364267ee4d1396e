#include "core/brush/reservoir.h"

#include <gtest/gtest.h>

#include "core/brush/builtin_brushes.h"
#include "core/brush/collect_paint.h"

namespace pentimento {
namespace {

PaintLoad load_of(float height_m, float amount, float other_amount = 0) {
  const float paint[] = {height_m, amount, other_amount}, share[] = {1, 1};
  return {paint, share, 0.05f};
}

constexpr int kMiddle = kReservoirColumns * (kReservoirRows / 2) + kReservoirColumns / 2;

/// Filled with one paint and then no longer just as it was loaded.
Reservoir holding(const PaintLoad& load) {
  Reservoir reservoir(2);
  reservoir.fill(load);
  reservoir.dirty_texel(0);
  return reservoir;
}

/// All cells of a box are touched, and their paint lies row by row.
std::vector<TouchedCells> all_cells_of(const FootprintBox& box) {
  std::vector<TouchedCells> rows;
  for (int y = 0; y < box.height; ++y)
    rows.push_back({0, box.width, static_cast<std::size_t>(y * box.width)});
  return rows;
}

TEST(Reservoir, RefillGoesAShareOfTheWay) {
  const Tip tip(*builtin_brush("round"));
  Reservoir reservoir = holding(load_of(0.002f, 0.04f));
  reservoir.refill(load_of(0.002f, 0, 0.04f), tip, 0.25f);
  const float* middle = reservoir.texel(kMiddle);
  EXPECT_FLOAT_EQ(middle[1], 0.03f);
  EXPECT_FLOAT_EQ(middle[2], 0.01f);
  EXPECT_FLOAT_EQ(middle[0], 0.002f);
}

TEST(Reservoir, RefillKeepsWhatWasLiftedAsVolume) {
  const Tip tip(*builtin_brush("round"));
  Reservoir reservoir = holding(load_of(0.006f, 0.12f));  // three loads
  const PaintLoad load = load_of(0.002f, 0.04f);
  reservoir.refill(load, tip, 0.5f);
  const float* middle = reservoir.texel(kMiddle);
  EXPECT_FLOAT_EQ(load.volume_of(middle), 3 * load.volume_m);
}

TEST(Reservoir, DroppingTheSurplusEndsAtTheLoad) {
  const Tip tip(*builtin_brush("round"));
  Reservoir reservoir = holding(load_of(0.006f, 0.12f));
  const PaintLoad load = load_of(0.002f, 0.04f);
  reservoir.refill(load, tip, 0);
  EXPECT_GT(reservoir.weighted_surplus(), 0);
  for (int i = 0; i < 4000; ++i) {
    reservoir.drop_surplus(load, tip, 0.05f);
    reservoir.refill(load, tip, 0);
  }
  const float* middle = reservoir.texel(kMiddle);
  EXPECT_NEAR(middle[0], 0.002f, 1e-8f);
  EXPECT_NEAR(middle[1], 0.04f, 1e-7f);
}

TEST(Reservoir, HoldsSeveralPaintsSideBySide) {
  const Tip tip(*builtin_brush("round"));
  PaintLoad load = load_of(0.002f, 0.04f);
  load.set_rows(load_of(0.002f, 0, 0.04f), kReservoirRows / 2, kReservoirRows);
  Reservoir reservoir(2);
  reservoir.fill(load);
  std::vector<float> out(static_cast<std::size_t>(reservoir.stride()));
  reservoir.sample(0, -0.25f, out.data());
  EXPECT_FLOAT_EQ(out[1], 0.04f);
  EXPECT_FLOAT_EQ(out[2], 0);
  reservoir.sample(0, 0.25f, out.data());
  EXPECT_FLOAT_EQ(out[1], 0);
  EXPECT_FLOAT_EQ(out[2], 0.04f);
  // What each side picked up gives way to its own paint.
  float* texel = reservoir.dirty_texel(kMiddle);
  texel[1] = 0.04f, texel[2] = 0;
  reservoir.refill(load, tip, 0.25f);
  EXPECT_FLOAT_EQ(texel[1], 0.03f);
  EXPECT_FLOAT_EQ(texel[2], 0.01f);
}

TEST(Reservoir, SamplesBetweenTexels) {
  Reservoir reservoir(2);
  reservoir.dirty_texel(0)[0] = 1;
  reservoir.dirty_texel(1)[0] = 3;
  std::vector<float> out(static_cast<std::size_t>(reservoir.stride()));
  reservoir.sample(1.0f / kReservoirColumns - 0.5f, -0.5f, out.data());
  EXPECT_NEAR(out[0], 2, 1e-5);
}

Reservoir filled_anyhow(int channels) {
  Reservoir reservoir(channels);
  for (int texel = 0; texel < kReservoirTexels; ++texel)
    for (int i = 0; i <= channels; ++i)
      reservoir.dirty_texel(texel)[i] = static_cast<float>((texel * 37 + i * 11) % 101) / 101;
  return reservoir;
}

// A row that begins and ends beyond the tip; texels of one vector and of two.
TEST(Reservoir, SamplesARowAsEachOfItsCells) {
  for (const int channels : {3, 6}) {
    const Reservoir reservoir = filled_anyhow(channels);
    const TipRow row{-0.7f, 0.6f, 0.0091f, -0.0083f};
    constexpr int kFirst = 3, kCells = 150;
    const std::size_t stride = static_cast<std::size_t>(reservoir.stride());
    std::vector<float> together(kCells * stride), alone(stride);
    reservoir.sample_row(row, kFirst, kCells, together.data());
    for (int x = 0; x < kCells; ++x) {
      reservoir.sample(row.u(kFirst + x), row.v(kFirst + x), alone.data());
      for (std::size_t i = 0; i < stride; ++i)
        ASSERT_EQ(together[static_cast<std::size_t>(x) * stride + i], alone[i]) << x;
    }
  }
}

// The same, with each component by itself: of cells that lie texels apart, and of cells of which
// many lie between the same four.
TEST(Reservoir, SamplesARowPlaneByPlane) {
  for (const int channels : {3, 6}) {
    const Reservoir reservoir = filled_anyhow(channels);
    constexpr int kFirst = 3;
    const std::size_t stride = static_cast<std::size_t>(reservoir.stride());
    std::vector<float> planes(stride * kSampledCells), alone(stride);
    for (const TipRow& row :
         {TipRow{-0.7f, 0.6f, 0.0291f, -0.0283f}, TipRow{-0.1f, 0.2f, 0.0041f, -0.0023f}})
      for (const int cells : {4, 8, 12, kSampledCells}) {
        reservoir.sample_planes(row, kFirst, cells, planes.data());
        for (int x = 0; x < cells; ++x) {
          reservoir.sample(row.u(kFirst + x), row.v(kFirst + x), alone.data());
          for (std::size_t k = 0; k < stride; ++k)
            ASSERT_EQ(planes[k * kSampledCells + static_cast<std::size_t>(x)], alone[k]) << x;
        }
      }
  }
}

TEST(Gather, TheBrushGainsPerAreaWhatTheCanvasLost) {
  const BrushDefinition brush = *builtin_brush("round");
  const Tip tip(brush);
  const CanvasGeometry geometry{100, 75, 0.2, 0.15};
  Stamp stamp;
  stamp.x_m = 0.1;
  stamp.y_m = 0.07;
  for (const float diameter_m : {0.004f, 0.03f, 0.1f}) {
    stamp.diameter_m = diameter_m;
    const TipPose pose = pose_of(stamp, brush, 0);
    const FootprintBox box = box_of(pose, tip.extent(), geometry);
    std::vector<float> picked_up(static_cast<std::size_t>(box.width * box.height * 4), 0.0f);
    std::vector<double> sum(3, 0.0);
    for (std::size_t i = 0; i < picked_up.size(); i += 4) {
      picked_up[i] = 1e-5f * static_cast<float>(1 + i % 7);
      picked_up[i + 1] = 1e-3f * static_cast<float>(i % 3);
      sum[0] += static_cast<double>(picked_up[i]);
      sum[1] += static_cast<double>(picked_up[i + 1]);
    }
    Reservoir reservoir(2);
    const std::vector<TouchedCells> rows = all_cells_of(box);
    collect_picked_up({picked_up, 4, rows}, pose, box, geometry, tip, reservoir);
    double gained[3] = {0, 0, 0};
    for (int i = 0; i < kReservoirTexels; ++i)
      for (int k = 0; k < 3; ++k) gained[k] += static_cast<double>(reservoir.texel(i)[k]);
    const double texel_area =
        static_cast<double>(diameter_m) * static_cast<double>(diameter_m) / kReservoirTexels;
    for (int k = 0; k < 2; ++k)  // 640 float texels: 1e-6
      EXPECT_NEAR(
          gained[k] * texel_area / (sum[static_cast<std::size_t>(k)] * geometry.cell_area_m2()), 1,
          1e-6)
          << diameter_m;
    EXPECT_EQ(gained[2], 0);
  }
}

TEST(Gather, FinePaintArrivesWhereItsCellIs) {
  const BrushDefinition brush = *builtin_brush("round");
  const Tip tip(brush);
  const CanvasGeometry geometry{400, 300, 0.2, 0.15};
  Stamp stamp;
  stamp.x_m = 0.1;
  stamp.y_m = 0.07;
  stamp.diameter_m = 0.1f;
  const TipPose pose = pose_of(stamp, brush, 0);
  const FootprintBox box = box_of(pose, tip.extent(), geometry);
  const std::vector<TouchedCells> rows = all_cells_of(box);
  for (const int right : {3, 7, 12}) {  // cells from the middle, where all texels are the tip's
    std::vector<float> picked_up(static_cast<std::size_t>(box.width * box.height * 4), 0.0f);
    const int x = box.width / 2 + right, y = box.height / 2 + 5;
    picked_up[static_cast<std::size_t>((y * box.width + x) * 4)] = 1;
    Reservoir reservoir(1);
    collect_picked_up({picked_up, 4, rows}, pose, box, geometry, tip, reservoir);
    double sum = 0, u = 0, v = 0;
    for (const TipTexel& t : tip.texels()) {
      const double paint = static_cast<double>(reservoir.texel(t.index)[0]);
      sum += paint;
      u += paint * static_cast<double>(t.u);
      v += paint * static_cast<double>(t.v);
    }
    const TipRow row = tip_row(pose, box, geometry, box.y + y);
    // Bilinear shares keep the place, up to the rounding of floats.
    EXPECT_NEAR(u / sum, static_cast<double>(row.u(x)), 1e-6);
    EXPECT_NEAR(v / sum, static_cast<double>(row.v(x)), 1e-6);
  }
}

TEST(Gather, EveryComponentIsTreatedAlike) {
  // A component that is the sum of two others on the canvas is so in the brush too.
  const BrushDefinition brush = *builtin_brush("flat");
  const Tip tip(brush);
  const CanvasGeometry geometry{400, 300, 0.2, 0.15};
  Stamp stamp;
  stamp.x_m = 0.1;
  stamp.y_m = 0.07;
  for (const float diameter_m : {0.004f, 0.03f, 0.1f}) {
    stamp.diameter_m = diameter_m;
    const TipPose pose = pose_of(stamp, brush, 0);
    const FootprintBox box = box_of(pose, tip.extent(), geometry);
    std::vector<float> picked_up(static_cast<std::size_t>(box.width * box.height * 4), 0.0f);
    for (std::size_t i = 0; i < picked_up.size(); i += 4) {
      picked_up[i] = 1e-3f * static_cast<float>(i % 3);
      picked_up[i + 1] = 1e-3f * static_cast<float>(1 + i % 7);
      picked_up[i + 2] = picked_up[i] + 2 * picked_up[i + 1];
    }
    Reservoir reservoir(2);
    const std::vector<TouchedCells> rows = all_cells_of(box);
    collect_picked_up({picked_up, 4, rows}, pose, box, geometry, tip, reservoir);
    for (const TipTexel& t : tip.texels()) {
      const float* paint = reservoir.texel(t.index);
      EXPECT_NEAR(paint[2], paint[0] + 2 * paint[1],
                  1e-5f * paint[2]);  // rounding of some 100 sums
    }
  }
}

TEST(BuiltinBrushes, AreTheEightThatLogsMayName) {
  EXPECT_EQ(builtin_brush_names(), (std::vector<std::string>{"round", "flat", "filbert", "bristle",
                                                             "fan", "rigger", "knife", "rag"}));
  for (const std::string& name : builtin_brush_names()) EXPECT_EQ(builtin_brush(name)->name, name);
  EXPECT_FALSE(builtin_brush("broom").has_value());
}

}  // namespace
}  // namespace pentimento

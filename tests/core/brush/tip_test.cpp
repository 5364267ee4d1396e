#include "core/brush/tip.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "core/brush/builtin_brushes.h"
#include "core/brush/resample.h"
#include "core/brush/tip_pose.h"

namespace pentimento {
namespace {

/// Mean of the tip over its square as a grid of `cells` cells per diameter sees it, turned.
double mass_on_grid(const Tip& tip, double cells, double angle) {
  const double cell = 1 / cells;
  const TipLevel& level = tip.level_for(static_cast<float>(cell));
  const int reach = static_cast<int>(cells) + 3;
  const double c = std::cos(angle), s = std::sin(angle);
  double sum = 0;
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      const double px = (x + 0.31) * cell, py = (y + 0.77) * cell;  // anywhere on the grid
      sum += static_cast<double>(
          level.at(static_cast<float>(c * px + s * py), static_cast<float>(c * py - s * px)));
    }
  }
  return sum * cell * cell;
}

TEST(Tip, LaysTheSameMassOnEveryGrid) {
  for (const std::string& name : builtin_brush_names()) {
    const Tip tip(*builtin_brush(name));
    ASSERT_GT(tip.mean(), 0.02f) << name;
    for (const double cells : {21.3, 25.0, 41.7, 60.0, 118.9, 240.0}) {
      for (const double angle : {0.0, 0.4, 1.3}) {
        // 1 %: a blade 3 cells thick between the cells' centres; the transfer scales it away.
        EXPECT_NEAR(mass_on_grid(tip, cells, angle) / static_cast<double>(tip.mean()), 1, 0.01)
            << name << ", " << cells << " cells, " << angle << " rad";
      }
    }
  }
}

TEST(Tip, ValuesLieBetweenZeroAndOne) {
  for (const std::string& name : builtin_brush_names()) {
    const Field<float> map = draw_tip(*builtin_brush(name), 64, 1);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) EXPECT_TRUE(map(x, y) >= 0 && map(x, y) <= 1) << name;
  }
}

TEST(Tip, ABladeEndsAtItsEnds) {
  const Tip knife(*builtin_brush("knife"));
  // knife: its value is 0.6 in the middle and rises to 1 between 0.8 and 0.95 of its half length.
  EXPECT_EQ(knife.end_table().at(0), 0);
  EXPECT_EQ(knife.end_table().at(0.38f), 0);
  EXPECT_EQ(knife.end_table().at(0.47f), 1);
  EXPECT_EQ(knife.end_table().at(-0.47f), 1);
  for (int i = 0; i <= BristleTable::kSteps; ++i) {
    const float end = knife.end_table().at(BristleTable::at_step(i));
    EXPECT_TRUE(end >= 0 && end <= 1);
  }
}

TEST(BristleTable, ARowIsReadAsEachOfItsPlaces) {
  BristleTable table;
  for (int i = 0; i <= BristleTable::kSteps; ++i) table[i] = static_cast<float>(i * i % 17);
  constexpr int kFirst = 3;
  std::array<float, BristleTable::kMostInRow> row{};
  // From before the tip to beyond it, backwards, in steps of many steps and of none.
  for (const auto& [v0, dv] : {std::pair{-0.7f, 0.021f}, {0.6f, -0.0191f}, {0.1f, 0.0001f}, {0, 0}})
    for (const int n : {1, 17, BristleTable::kMostInRow}) {
      table.row(v0, dv, kFirst, n, row.data());
      for (int i = 0; i < n; ++i)
        EXPECT_EQ(row[static_cast<std::size_t>(i)],
                  table.at(v0 + dv * static_cast<float>(kFirst + i)))
            << v0 << ' ' << i;
    }
}

TEST(BristleTable, ItsMeanIsThatOfManyPlaces) {
  BristleTable table;
  for (int i = 0; i <= BristleTable::kSteps; ++i) table[i] = static_cast<float>(i * i % 17);
  for (const float width : {0.001f, 0.03f, 0.4f, 1.5f}) {
    const BristleTable mean = table.averaged(width);
    for (const int step : {0, 3, 64, 127, 128}) {
      const float v = BristleTable::at_step(step);
      double sum = 0;
      for (int i = 0; i < 100000; ++i)
        sum += static_cast<double>(
            table.at(v + width * ((static_cast<float>(i) + 0.5f) / 100000 - 0.5f)));
      EXPECT_NEAR(static_cast<double>(mean.at(v)), sum / 100000, 2e-3) << width << ", " << step;
    }
  }
}

TEST(Tip, TheNameChoosesTheHairs) {
  BrushDefinition a = *builtin_brush("bristle");
  BrushDefinition b = *builtin_brush("bristle");
  b.name = "another";
  const Tip one(a), same(a), other(b);
  int differing = 0;
  for (int i = 0; i < 50; ++i) {
    const float v = -0.45f + 0.018f * static_cast<float>(i);
    EXPECT_EQ(one.level_for(0.02f).at(0, v), same.level_for(0.02f).at(0, v));
    differing += one.level_for(0.02f).at(0, v) != other.level_for(0.02f).at(0, v) ? 1 : 0;
  }
  EXPECT_GT(differing, 25);
}

TEST(Tip, DriesWithoutAJump) {
  // Bristles of a wet brush all give; so do they just below where drying begins, at 0.8.
  for (const std::string& name : builtin_brush_names()) {
    const Tip tip(*builtin_brush(name));
    const TipLevel wet = tip.level_for(0.02f), drying = tip.level_for(0.02f, {1, 0.7999f});
    for (int i = 0; i < 50; ++i) {
      const float v = -0.45f + 0.018f * static_cast<float>(i);
      // The table's last step lets go of all at 0.114 below: a thousandth of it.
      EXPECT_NEAR(drying.at(0, v), wet.at(0, v), 2e-3f) << name << " at " << v;
    }
  }
}

TEST(Tip, BristlesAreUneven) {
  const Tip tip(*builtin_brush("bristle"));
  // The load across the stroke, summed along it: furrows need hills and hollows.
  double low = 1e9, high = 0;
  for (int i = 0; i < 60; ++i) {
    const float v = -0.4f + 0.8f * static_cast<float>(i) / 59;
    double sum = 0;
    for (int k = 0; k < 100; ++k)
      sum += static_cast<double>(tip.level_for(0.01f).at(-0.5f + 0.01f * static_cast<float>(k), v));
    low = std::min(low, sum);
    high = std::max(high, sum);
  }
  EXPECT_GT(high, 2 * low);
}

TEST(Tip, ATextureIsUsedAsItIs) {
  BrushDefinition brush;
  brush.shape = TipShape::kTexture;
  brush.texture = Field<float>(8, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 4; x < 8; ++x) brush.texture(x, y) = 0.5f;
  const Tip tip(brush);
  EXPECT_FLOAT_EQ(tip.mean(), 0.25f);
  EXPECT_FLOAT_EQ(tip.level_for(0.05f).at(0.25f, 0), 0.5f);
  EXPECT_FLOAT_EQ(tip.level_for(0.05f).at(-0.25f, 0), 0.0f);
}

TEST(Tip, GripIsOneOnAverage) {
  for (const std::string& name : builtin_brush_names()) {
    const Tip tip(*builtin_brush(name));
    double sum = 0;
    for (int i = 0; i < 400; ++i) {
      const float grip = tip.grip_table().at(-0.5f + (static_cast<float>(i) + 0.5f) / 400);
      EXPECT_TRUE(grip >= 0 && grip <= 2);
      sum += static_cast<double>(grip);
    }
    EXPECT_NEAR(sum / 400, 1, 0.35) << name;  // some twenty clumps of bristle
  }
}

TEST(Resample, KeepsTheMeanExactlyBetweenAnySizes) {
  Field<float> in(7, 5);
  double mean = 0;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x) mean += in(x, y) = static_cast<float>((3 * x + 5 * y) % 11);
  mean /= 35;
  for (const int size : {1, 2, 3, 7, 16}) {
    const Field<float> out = resample_area(in, size, size);
    double sum = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) sum += static_cast<double>(out(x, y));
    EXPECT_NEAR(sum / (size * size), mean, 1e-5 * mean);  // float texels
  }
}

Stamp upright() {
  Stamp stamp;
  stamp.x_m = 0.1;
  stamp.y_m = 0.1;
  stamp.diameter_m = 0.02f;
  return stamp;
}

TEST(Footprint, CanvasToTipAndBackAreInverse) {
  Stamp stamp = upright();
  stamp.tilt_x_rad = 0.7f;
  stamp.tilt_y_rad = -0.3f;
  stamp.twist_rad = 1.1f;
  const TipPose p = pose_of(stamp, *builtin_brush("flat"), 0);
  EXPECT_NEAR(p.u_x * p.x_u + p.u_y * p.y_u, 1, 1e-5);
  EXPECT_NEAR(p.u_x * p.x_v + p.u_y * p.y_v, 0, 1e-5);
  EXPECT_NEAR(p.v_x * p.x_u + p.v_y * p.y_u, 0, 1e-5);
  EXPECT_NEAR(p.v_x * p.x_v + p.v_y * p.y_v, 1, 1e-5);
  // Area of the tip's square: the diameter squared, whatever the lean.
  EXPECT_NEAR((p.x_u * p.y_v - p.x_v * p.y_u) / (0.02f * 0.02f), 1, 1e-5);
}

TEST(Footprint, PressureShrinksAndTiltShiftsAndStretches) {
  const BrushDefinition round = *builtin_brush("round");
  Stamp stamp = upright();
  stamp.pressure = 0;
  EXPECT_FLOAT_EQ(pose_of(stamp, round, 0).diameter_m, 0.02f * (1 - round.size_pressure));
  stamp.pressure = 1;
  EXPECT_FLOAT_EQ(pose_of(stamp, round, 0).diameter_m, 0.02f);
  stamp.tilt_x_rad = 0.6f;
  const TipPose tilted = pose_of(stamp, round, 0);
  EXPECT_GT(tilted.x_m, 0.1);              // towards the handle
  EXPECT_GT(tilted.x_u, 0.02f);            // longer along the lean
  EXPECT_LT(std::abs(tilted.y_v), 0.02f);  // narrower across
}

TEST(Footprint, TwistIsClockwiseAsSeen) {
  Stamp stamp = upright();
  stamp.twist_rad = 1.57079633f;
  const TipPose p = pose_of(stamp, *builtin_brush("flat"), 0);
  EXPECT_NEAR(p.y_u, 0.02f, 1e-6f);  // u axis, right at first, now points down
}

TEST(Footprint, TheTipLiesUnderTheHandleInBothAxes) {
  const BrushDefinition flat = *builtin_brush("flat");
  const double shift_m = 0.25 * 0.02 * std::sin(0.5);  // a quarter diameter times the lean
  for (const bool down : {false, true}) {
    Stamp stamp = upright();
    (down ? stamp.tilt_y_rad : stamp.tilt_x_rad) = 0.5f;
    const TipPose pose = pose_of(stamp, flat, 0);
    // The shift is a float of some 2e-3 m.
    EXPECT_NEAR(pose.x_m, 0.1 + (down ? 0 : shift_m), 1e-9);
    EXPECT_NEAR(pose.y_m, 0.1 + (down ? shift_m : 0), 1e-9);
  }
}

TEST(Footprint, TheBoxHoldsTheWholeTip) {
  const CanvasGeometry geometry{100, 80, 0.2, 0.2};  // cells of 2 by 2.5 mm
  for (const float twist_rad : {0.0f, 0.4f, 1.2f}) {
    Stamp stamp = upright();
    stamp.twist_rad = twist_rad;
    const TipPose pose = pose_of(stamp, *builtin_brush("flat"), 0);
    const FootprintBox box = box_of(pose, TipExtent(), geometry);
    for (int y = 0; y < geometry.height; ++y) {
      const TipRow row = tip_row(pose, {0, 0, geometry.width, 1, true}, geometry, y);
      for (int x = 0; x < geometry.width; ++x) {
        if (std::abs(row.u(x)) > 0.5f || std::abs(row.v(x)) > 0.5f) continue;
        // One cell more on each side, into which the bilinear tip fades.
        EXPECT_TRUE(x > box.x && x + 1 < box.x + box.width) << x << ", " << twist_rad;
        EXPECT_TRUE(y > box.y && y + 1 < box.y + box.height) << y << ", " << twist_rad;
      }
    }
  }
}

TEST(Footprint, AGridDrawsNoTipFinerThanOneAndAHalfOfItsCells) {
  const CanvasGeometry grid{100, 400, 0.2,
                            0.2};  // cells of 2 mm x 0.5 mm: 1 mm each, by their area
  EXPECT_NEAR(cell_size_m(grid), 0.001f, 1e-9f);
  Stamp stamp = upright();
  EXPECT_FLOAT_EQ(pose_on(grid, stamp, *builtin_brush("round")).diameter_m, 0.02f);
  stamp.diameter_m = 1e-4f;
  EXPECT_FLOAT_EQ(pose_on(grid, stamp, *builtin_brush("round")).diameter_m, 0.0015f);
}

TEST(Footprint, BoxesAreCutAtTheCanvas) {
  const CanvasGeometry geometry{100, 100, 0.2, 0.2};
  Stamp stamp = upright();
  const TipExtent all;
  EXPECT_TRUE(box_of(pose_of(stamp, *builtin_brush("round"), 0), all, geometry).inside);
  stamp.x_m = 0;
  const FootprintBox cut = box_of(pose_of(stamp, *builtin_brush("round"), 0), all, geometry);
  EXPECT_FALSE(cut.inside);
  EXPECT_EQ(cut.x, 0);
  EXPECT_LE(cut.width, 8);
  stamp.x_m = -1;
  EXPECT_TRUE(box_of(pose_of(stamp, *builtin_brush("round"), 0), all, geometry).empty());
  stamp.x_m = 1e6;
  EXPECT_TRUE(box_of(pose_of(stamp, *builtin_brush("round"), 0), all, geometry).empty());
}

}  // namespace
}  // namespace pentimento

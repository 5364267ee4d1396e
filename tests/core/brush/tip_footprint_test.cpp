#include "core/brush/tip_footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/brush/builtin_brushes.h"

namespace pentimento {
namespace {

/// Value of the tip at (u, v); 0 where it is too faint to touch.
float plain_value(const TipLevel& level, float u, float v) {
  const float value = level.at(u, v);
  return value < 1e-3f ? 0 : value;
}

/// A stamp of 20 mm on cells of 0.1 mm, turned, drawn along x.
class TipPrintTest : public ::testing::Test {
 protected:
  TipPrintTest() : brush_(builtin_brush("flat")->clone()), tip_(brush_) {
    stamp_.x_m = stamp_.y_m = 0.02;
    stamp_.diameter_m = 0.02f;
    stamp_.twist_rad = 0.4f;
    stamp_.direction = {1, 0};
    plan_.tip = &tip_;
    plan_.state = {0.6f, 1};
  }

  /// The largest difference from the plain mean over the places, and their mean value.
  std::pair<double, double> difference(float travel_m, int prints) {
    stamp_.travel_m = travel_m;
    plan_.stamp = stamp_;
    plan_.pose = pose_of(stamp_, brush_, kCell_m);
    const TipLevel level = stamp_tip_level(plan_, kCell_m);
    TipFootprint swept;
    swept.draw_swept(plan_, kCell_m);
    double most = 0, mean = 0;
    std::vector<float> value(400);
    for (int y = 0; y < 400; ++y) {
      const TipRow row = tip_row(plan_.pose, {0, 0, 400, 400, true}, {400, 400, 0.04, 0.04}, y);
      swept.row(row, 0, value);
      for (int x = 0; x < 400; ++x) {
        double sum = 0;
        for (int i = 0; i < prints; ++i) {
          const float way_m = travel_m *
                              (static_cast<float>(i) - 0.5f * static_cast<float>(prints - 1)) /
                              static_cast<float>(prints);
          sum += static_cast<double>(plain_value(level, row.u(x) + way_m * plan_.pose.u_x,
                                                 row.v(x) + way_m * plan_.pose.v_x));
        }
        most = std::max(
            most, std::abs(sum / prints - static_cast<double>(value[static_cast<std::size_t>(x)])));
        mean += sum / prints / (400.0 * 400.0);
      }
    }
    return {most, mean};
  }

  /// For cells of `cell_m`: root of the mean square difference from the finest tip's mean over each
  /// cell's area, of the print and of the tip read at the cells' centres; and the means of all.
  struct Coverage {
    double print_rms = 0, plain_rms = 0, print = 0, exact = 0;
  };
  Coverage coverage(float cell_m) {
    plan_.stamp = stamp_;
    plan_.pose = pose_of(stamp_, brush_, cell_m);
    const int cells = static_cast<int>(0.04f / cell_m);
    const CanvasGeometry grid{cells, cells, 0.04, 0.04};
    const TipLevel fine = stamp_tip_level(plan_, 1e-5f), own = stamp_tip_level(plan_, cell_m);
    TipFootprint print;
    print.draw_cells(plan_, cell_m);
    std::vector<float> value(static_cast<std::size_t>(cells));
    constexpr int kSub = 16;
    const CanvasGeometry sub{cells * kSub, cells * kSub, 0.04, 0.04};
    Coverage sum;
    for (int y = 0; y < cells; ++y) {
      std::vector<double> exact(value.size(), 0.0);
      for (int j = 0; j < kSub; ++j) {
        const TipRow row = tip_row(plan_.pose, {}, sub, y * kSub + j);
        for (int x = 0; x < cells * kSub; ++x)
          exact[static_cast<std::size_t>(x / kSub)] +=
              static_cast<double>(fine.at(row.u(x), row.v(x))) / (kSub * kSub);
      }
      const TipRow row = tip_row(plan_.pose, {}, grid, y);
      print.row(row, 0, value);
      for (int x = 0; x < cells; ++x) {
        const std::size_t i = static_cast<std::size_t>(x);
        const double plain = static_cast<double>(own.at(row.u(x), row.v(x)));
        const double printed = static_cast<double>(value[i]);
        sum.print_rms += (printed - exact[i]) * (printed - exact[i]);
        sum.plain_rms += (plain - exact[i]) * (plain - exact[i]);
        sum.print += printed;
        sum.exact += exact[i];
      }
    }
    const double n = static_cast<double>(cells) * cells;
    return {std::sqrt(sum.print_rms / n), std::sqrt(sum.plain_rms / n), sum.print / n,
            sum.exact / n};
  }

  /// Of 400 x 400 cells: how many a print says it can touch. None beyond those is touched.
  int cells_in_reach(const TipFootprint& print) {
    int count = 0;
    std::vector<float> value(400);
    for (int y = 0; y < 400; ++y) {
      const TipRow row = tip_row(plan_.pose, {0, 0, 400, 400, true}, {400, 400, 0.04, 0.04}, y);
      const TipFootprint::CellSpan touched_span = print.touched_span(row, 0, 400);
      print.row(row, 0, value);
      for (int x = 0; x < 400; ++x) {
        const bool in_reach = x >= touched_span.begin && x < touched_span.end;
        EXPECT_TRUE(in_reach || value[static_cast<std::size_t>(x)] == 0) << x << ", " << y;
      }
      count += touched_span.end - touched_span.begin;
    }
    return count;
  }

  static constexpr float kCell_m = 1e-4f;
  BrushDefinition brush_;
  Tip tip_;
  Stamp stamp_;
  StampPlan plan_;
};

// What a detail canvas gets in the cell: within the texels' own averaging, a third of a cell.
TEST_F(TipPrintTest, OfACoarseCellIsTheMeanOverItsArea) {
  for (const float cell_m : {0.5e-3f, 1e-3f, 2e-3f}) {
    const Coverage c = coverage(cell_m);
    EXPECT_LT(c.print_rms, 0.5 * c.plain_rms) << cell_m;
    EXPECT_LT(c.print_rms, 0.05 * c.exact / 0.25) << cell_m;  // the tip covers a quarter
    EXPECT_NEAR(c.print / c.exact, 1, 0.01) << cell_m;
  }
}

TEST_F(TipPrintTest, IsTheTipWhereThereIsNoWay) {
  const auto [most, mean] = difference(0, 1);
  EXPECT_GT(mean, 0.01);
  // Rounding, but for values at the edge of the faintest, 1e-3, which is left out.
  EXPECT_LT(most, 1.1e-3);
}

TEST_F(TipPrintTest, DriesAsTheTipDoes) {
  for (const float density_frac : {0.75f, 0.5f, 0.27f}) {
    plan_.state.density_frac = density_frac;
    const auto [most, mean] = difference(0, 1);
    EXPECT_GT(mean, 0.005) << density_frac;
    // The print multiplies whole rows of texels by the table, the tip each place: within a row of
    // 1/128 the table rises by up to 0.1.
    EXPECT_LT(most, 0.1) << density_frac;
  }
}

TEST_F(TipPrintTest, TouchesNothingBeyondItsReach) {
  plan_.extent = tip_.extent();
  const float turns_rad[] = {0, 0.4f, 0.785398f, 1.570796f, 2.5f};
  for (const float turn_rad : turns_rad) {
    for (const float travel_m : {0.0f, 6e-4f}) {
      stamp_.twist_rad = turn_rad;
      stamp_.travel_m = travel_m;
      plan_.stamp = stamp_;
      plan_.pose = pose_of(stamp_, brush_, kCell_m);
      TipFootprint print;
      print.draw_swept(plan_, kCell_m);
      // The tip's rectangle and a few cells all around it, however it is turned.
      const float cover = plan_.extent.u * plan_.extent.v * 200 * 200;
      EXPECT_LT(cells_in_reach(print), 1.5f * cover) << turn_rad << ", " << travel_m;
      print.draw_cells(plan_, kCell_m);
      cells_in_reach(print);
    }
  }
}

// Maps are kept from stamp to stamp, and only the rows that a tip has are made empty.
TEST_F(TipPrintTest, DoesNotShowTheStampBefore) {
  const Tip round(*builtin_brush("round"));
  StampPlan before = plan_;
  before.tip = &round;
  before.extent = round.extent();
  before.stamp = stamp_;
  before.pose = pose_of(stamp_, *builtin_brush("round"), kCell_m);
  plan_.extent = tip_.extent();
  ASSERT_LT(plan_.extent.u, 0.5f);  // a narrow tip
  stamp_.travel_m = 6e-4f;
  plan_.stamp = stamp_;
  plan_.pose = pose_of(stamp_, brush_, kCell_m);
  const auto draws = {&TipFootprint::draw_cells, &TipFootprint::draw_swept};
  for (const auto draw : draws) {
    for (const float cell_m : {1e-4f, 5e-4f, 2e-3f}) {
      TipFootprint used, fresh;
      for (const auto first : draws) (used.*first)(before, cell_m);
      (used.*draw)(plan_, cell_m);
      (fresh.*draw)(plan_, cell_m);
      const int cells = static_cast<int>(0.04f / cell_m);
      const CanvasGeometry grid{cells, cells, 0.04, 0.04};
      std::vector<float> value(static_cast<std::size_t>(cells)), wanted = value;
      float most = 0;
      for (int y = 0; y < cells; ++y) {
        const TipRow row = tip_row(plan_.pose, {0, 0, cells, cells, true}, grid, y);
        used.row(row, 0, value);
        fresh.row(row, 0, wanted);
        ASSERT_EQ(value, wanted) << "row " << y << ", cells of " << cell_m;
        most = std::max(most, *std::max_element(wanted.begin(), wanted.end()));
      }
      EXPECT_GT(most, 0.1f);
    }
  }
}

TEST_F(TipPrintTest, IsTheMeanAlongTheWay) {
  const auto [most, mean] = difference(6e-4f, 6);
  EXPECT_GT(mean, 0.01);
  // Bilinear between texels twice: a bristle's flank rises by up to 0.4 per texel.
  EXPECT_LT(most, 0.15);
}

}  // namespace
}  // namespace pentimento

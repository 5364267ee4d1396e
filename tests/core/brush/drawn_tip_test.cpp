#include "core/brush/drawn_tip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "core/brush/builtin_brushes.h"
#include "core/brush/edge_cells.h"

namespace pentimento {
namespace {

constexpr CanvasGeometry kTipGrid{80, 60, 0.08, 0.06};

/// A slanting stamp of 20 mm in the middle of cells of 1 mm, dry enough that hairs part.
class DrawnTipTest : public ::testing::Test {
 protected:
  explicit DrawnTipTest(const char* brush = "bristle")
      : brush_(builtin_brush(brush)->clone()), tip_(brush_) {
    Stamp stamp;
    stamp.x_m = 0.04;
    stamp.y_m = 0.03;
    stamp.diameter_m = 0.02f;
    stamp.twist_rad = 0.4f;
    stamp.direction = {0.6f, 0.8f};
    stamp.travel_m = 1e-3f;
    plan_ = plan_of(stamp);
  }

  StampPlan plan_of(const Stamp& stamp) const {
    StampPlan plan;
    plan.stamp = stamp;
    plan.tip = &tip_;
    plan.pose = pose_on(kTipGrid, stamp, brush_);
    plan.extent = tip_.extent();
    plan.box = box_of(plan.pose, plan.extent, kTipGrid);
    plan.state = {0.8f, 0.4f};
    return plan;
  }

  BrushDefinition brush_;
  Tip tip_;
  StampPlan plan_;
};

TEST_F(DrawnTipTest, RowsHoldTheFootprintAndWhereItTouches) {
  DrawnTip drawn(kTipGrid);
  drawn.draw(plan_, false);
  TipFootprint footprint;
  footprint.draw_cells(plan_, cell_size_m(kTipGrid));
  std::vector<float> value(static_cast<std::size_t>(plan_.box.width));
  int touched = 0;
  for (int y = 0; y < plan_.box.height; ++y) {
    footprint.row(tip_row(plan_.pose, plan_.box, kTipGrid, plan_.box.y + y), 0, value);
    const DrawnTipRow& row = drawn.row(y);
    const auto is_touched = [](float v) { return v > 0; };
    const auto first = std::find_if(value.begin(), value.end(), is_touched);
    const auto last = std::find_if(value.rbegin(), value.rend(), is_touched).base();
    if (first == value.end()) {
      EXPECT_EQ(row.touched.count(), 0u) << y;
      continue;
    }
    ASSERT_EQ(row.touched.begin, first - value.begin()) << y;
    ASSERT_EQ(row.touched.end, last - value.begin()) << y;
    EXPECT_LE(row.span.begin, row.touched.begin);
    EXPECT_GE(row.span.end, row.touched.end);
    for (int x = row.touched.begin; x < row.touched.end; ++x, ++touched)
      EXPECT_EQ(row.value[x], value[static_cast<std::size_t>(x)]) << x << ',' << y;
  }
  EXPECT_GT(touched, 100);
  const BristleTable passed = passed_shares(plan_, kTipGrid);
  for (int i = 0; i <= BristleTable::kSteps; ++i) {
    const float v = static_cast<float>(i) / BristleTable::kSteps - 0.5f;
    EXPECT_EQ(drawn.passed().at(v), passed.at(v)) << v;
  }
}

TEST_F(DrawnTipTest, RowsMayBeDrawnInAnyOrder) {
  DrawnTip whole(kTipGrid), backwards(kTipGrid);
  whole.draw(plan_, false);
  backwards.begin(plan_, false);
  for (int y = plan_.box.height - 1; y >= 0; --y) backwards.draw_row(y);
  for (int y = 0; y < plan_.box.height; ++y) {
    const DrawnTipRow &a = whole.row(y), &b = backwards.row(y);
    ASSERT_EQ(a.touched.begin, b.touched.begin) << y;
    ASSERT_EQ(a.touched.end, b.touched.end) << y;
    EXPECT_TRUE(std::equal(a.value + a.span.begin, a.value + a.span.end, b.value + b.span.begin));
  }
}

TEST_F(DrawnTipTest, IsOfTheStampThatItWasDrawnFor) {
  DrawnTip drawn(kTipGrid);
  EXPECT_FALSE(drawn.is_of(plan_));
  drawn.draw(plan_, false);
  EXPECT_TRUE(drawn.is_of(plan_));
  StampPlan other = plan_;
  other.stamp.y_m += 1e-9;
  EXPECT_FALSE(drawn.is_of(other));
  other = plan_;
  other.stamp.direction = {1, 0};
  EXPECT_FALSE(drawn.is_of(other));
  other = plan_;
  other.state.press = 0.7f;
  EXPECT_FALSE(drawn.is_of(other));
  other = plan_;
  other.state.density_frac = 0.3f;
  EXPECT_FALSE(drawn.is_of(other));
  const Tip twin(brush_);
  other = plan_;
  other.tip = &twin;
  EXPECT_FALSE(drawn.is_of(other));
  drawn.forget();
  EXPECT_FALSE(drawn.is_of(plan_));
}

class DrawnBladeTest : public DrawnTipTest {
 protected:
  DrawnBladeTest() : DrawnTipTest("knife") {}
};

TEST_F(DrawnBladeTest, ABladeHasEnds) {
  DrawnTip drawn(kTipGrid);
  drawn.draw(plan_, true);
  const BladeEnds ends = blade_ends(tip_, plan_.pose, kTipGrid);
  float most = 0;
  for (int i = 0; i <= BristleTable::kSteps; ++i) {
    const float v = static_cast<float>(i) / BristleTable::kSteps - 0.5f;
    EXPECT_EQ(drawn.ends().open.at(v), ends.open.at(v)) << v;
    EXPECT_EQ(drawn.ends().takes.at(v), ends.takes.at(v)) << v;
    most = std::max(most, ends.open.at(v));
  }
  EXPECT_GT(most, 0.5f);
}

}  // namespace
}  // namespace pentimento

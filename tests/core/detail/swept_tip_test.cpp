#include "core/detail/swept_tip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/brush/builtin_brushes.h"

namespace pentimento {
namespace {

/// A stamp of 20 mm on cells of 0.1 mm, turned, drawn along x.
class SweptTipTest : public ::testing::Test {
 protected:
  SweptTipTest() : brush_(builtin_brush("flat")->clone()), tip_(brush_) {
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
    SweptTip swept;
    swept.draw(plan_, kCell_m);
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
          sum += static_cast<double>(stamp_value(level, row.u(x) + way_m * plan_.pose.u_x,
                                                 row.v(x) + way_m * plan_.pose.v_x));
        }
        most = std::max(
            most, std::abs(sum / prints - static_cast<double>(value[static_cast<std::size_t>(x)])));
        mean += sum / prints / (400.0 * 400.0);
      }
    }
    return {most, mean};
  }

  static constexpr float kCell_m = 1e-4f;
  BrushDefinition brush_;
  Tip tip_;
  Stamp stamp_;
  StampPlan plan_;
};

TEST_F(SweptTipTest, IsTheTipWhereThereIsNoWay) {
  const auto [most, mean] = difference(0, 1);
  EXPECT_GT(mean, 0.01);
  // Rounding, but for values at the edge of the faintest, 1e-3, which is left out.
  EXPECT_LT(most, 1.1e-3);
}

TEST_F(SweptTipTest, IsTheMeanAlongTheWay) {
  const auto [most, mean] = difference(6e-4f, 6);
  EXPECT_GT(mean, 0.01);
  // Bilinear between texels twice: a hair's flank rises by up to 0.4 per texel.
  EXPECT_LT(most, 0.15);
}

}  // namespace
}  // namespace pentimento

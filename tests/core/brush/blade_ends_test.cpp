#include "core/brush/blade_ends.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/brush/builtin_brushes.h"
#include "core/brush/stamp_shares.h"

namespace pentimento {
namespace {

constexpr CanvasGeometry kMillimetres = {100, 50, 0.1, 0.05};  // cells of a millimetre

const Tip& knife() {
  static const Tip tip(*builtin_brush("knife"));
  return tip;
}

/// A blade of 20 mm that lies across a direction.
TipPose pose_at(double angle) {
  TipPose pose;
  pose.diameter_m = 0.02f;
  pose.v_x = static_cast<float>(-std::sin(angle)) / pose.diameter_m;
  pose.v_y = static_cast<float>(std::cos(angle)) / pose.diameter_m;
  return pose;
}

/// Mean of f(v) over a cell whose centre lies at v, from 100 x 100 places in it.
template <typename F>
double over_cell(const TipPose& pose, double v, const F& f) {
  double sum = 0;
  for (int j = 0; j < 100; ++j)
    for (int i = 0; i < 100; ++i)
      sum += f(v + 1e-3 * (static_cast<double>(pose.v_x) * ((i + 0.5) / 100 - 0.5) +
                           static_cast<double>(pose.v_y) * ((j + 0.5) / 100 - 0.5)));
  return sum / 1e4;
}

TEST(BladeEnds, ScrapesInTheMiddleAndNotUnderTheEnds) {
  constexpr CanvasGeometry kQuarters = {400, 200, 0.1, 0.05};  // cells of 0.25 mm
  const BladeEnds ends = blade_ends(knife(), pose_at(0), kQuarters);
  EXPECT_NEAR(ends.takes.at(0), 1, 1e-5);
  EXPECT_NEAR(ends.open.at(0), 0, 1e-6);
  // Half of a cell is 0.006 of the blade; a cell at 0.465 lies wholly under the end.
  EXPECT_NEAR(ends.takes.at(0.465f), 0, 1e-5);
  EXPECT_NEAR(ends.open.at(-0.465f), 1, 1e-6);
}

TEST(BladeEnds, ACellKeepsWhatItsPartsKeep) {
  for (const double angle : {0.0, 0.5, 0.785, 1.57}) {
    const TipPose pose = pose_at(angle);
    const BladeEnds ends = blade_ends(knife(), pose, kMillimetres);
    for (float v = 0.36f; v < 0.47f; v += 0.004f) {
      const auto end = [&](double at) {
        return static_cast<double>(knife().end_table().at(static_cast<float>(at)));
      };
      const double open = over_cell(pose, static_cast<double>(v), end);
      const double kept = over_cell(pose, static_cast<double>(v), [&](double at) {
        return std::pow(1 - static_cast<double>(kScraped), 1 - end(at));
      });
      // A box of the cell's variance in place of the cell's own distribution, a trapezium, is up to
      // 3.3 % of the whole off at the foot of the end.
      EXPECT_NEAR(static_cast<double>(ends.open.at(v)), open, 0.035) << angle << ", " << v;
      EXPECT_NEAR(
          std::pow(1 - static_cast<double>(kScraped), static_cast<double>(ends.takes.at(v))), kept,
          0.035)
          << angle << ", " << v;
    }
  }
}

TEST(BladeEnds, CellsThatAreNotSquareCountAsTheyLie) {
  constexpr CanvasGeometry kFlat = {100, 200, 0.1, 0.05};  // 1 mm x 0.25 mm
  const BladeEnds along = blade_ends(knife(), pose_at(1.5707963), kFlat);
  const BladeEnds across = blade_ends(knife(), pose_at(0), kFlat);
  // Where the end begins, a cell that is long across the blade reaches further under it.
  EXPECT_GT(along.open.at(0.4f), across.open.at(0.4f) + 0.02f);
}

}  // namespace
}  // namespace pentimento

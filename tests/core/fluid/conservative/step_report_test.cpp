#include "core/fluid/conservative/step_report.h"

#include <gtest/gtest.h>

namespace pentimento::conservative {
namespace {

CanvasState some_paint() {
  CanvasState state = make_canvas_state({64, 32, 0.064, 0.064}, 1, 1, 1, 0);  // 1 mm by 2 mm
  state.depth_m(20, 3) = 0.004f;
  state.depth_m(50, 30) = 0.009f;
  state.velocity_x_m_s(21, 3) = -0.09f;
  state.velocity_y_m_s(40, 4) = 0.1f;
  return state;
}

TEST(StepReport, HasMaximaOfTheCellsGiven) {
  const CanvasState state = some_paint();
  StepReport report;
  for (int k = 0; k < 2; ++k) {
    report.begin();
    report.add(state, {{3, 16, 32}, {4, 0, 48}}, 0.25 + 0.5 * k, Threads(2));
  }
  const auto found = report.statistics();
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0], std::make_pair(std::string("awake_share_mean"), 0.5));
  EXPECT_EQ(found[1], std::make_pair(std::string("awake_share_max"), 0.75));
  EXPECT_EQ(found[2].second, static_cast<double>(0.1f));
  EXPECT_EQ(found[3].second, static_cast<double>(0.004f)) << "row 30 is not among the cells";
}

TEST(StepReport, GoesOnWithTheNumbersOfAnother) {
  StepReport one, other;
  one.begin();
  one.add(some_paint(), {{3, 0, 64}}, 0.5, Threads());
  other.set(one.numbers());
  EXPECT_EQ(one.numbers().size(), StepReport::kNumbers);
  for (StepReport* report : {&one, &other}) report->begin();
  EXPECT_EQ(other.statistics(), one.statistics());
}

TEST(StepReport, TravelIsInCellsOfEachAxis) {
  const CanvasState state = some_paint();
  EXPECT_FLOAT_EQ(travel_cells(state, {{3, 0, 64}, {4, 0, 64}}, 0.1f), 9) << "9 mm of 1 mm";
  EXPECT_FLOAT_EQ(travel_cells(state, {{4, 0, 64}}, 0.1f), 5) << "10 mm of 2 mm";
  EXPECT_EQ(travel_cells(state, {}, 0.1f), 0);
}

}  // namespace
}  // namespace pentimento::conservative

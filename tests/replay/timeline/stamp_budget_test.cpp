#include "replay/timeline/stamp_budget.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

log::Header canvas() {
  log::Header header;
  header.canvas_width_m = 1;
  header.canvas_height_m = 1;
  return header;
}

log::Event touch(log::TouchPhase phase, double x_m, double y_m) {
  log::Touch at;
  at.phase = phase;
  at.x_m = x_m;
  at.y_m = y_m;
  log::Event event;
  event.action = at;
  return event;
}

log::Event slide(const char* name, double value) {
  log::Event event;
  event.action = log::Slider{name, value};
  return event;
}

/// A budget for a brush of 1 cm, a stamp every millimetre.
class Painted {
 public:
  explicit Painted(const log::Limits& limits = {}) : budget_(canvas(), brushes_, limits) {
    EXPECT_TRUE(budget_.add(slide("size", 0.01)));
    EXPECT_TRUE(budget_.add(slide("spacing", 0.1)));
  }
  Result<void> add(const log::Event& event) { return budget_.add(event); }
  /// What a straight stroke adds.
  double stroke(double x0_m, double x1_m) {
    const double before = budget_.stamps();
    EXPECT_TRUE(add(touch(log::TouchPhase::kDown, x0_m, 0.5)));
    EXPECT_TRUE(add(touch(log::TouchPhase::kUp, x1_m, 0.5)));
    return budget_.stamps() - before;
  }

 private:
  BrushTable brushes_;
  StampBudget budget_;
};

TEST(StampBudget, CountsStampsAlongTheWay) {
  EXPECT_NEAR(Painted().stroke(0.2, 0.8), 600, 3);
  EXPECT_NEAR(Painted().stroke(0.8, 0.2), 600, 3);
  EXPECT_NEAR(Painted().stroke(0.5, 0.5), 0, 3);
}

TEST(StampBudget, FarFromTheCanvasItCountsLittle) {
  EXPECT_LT(Painted().stroke(-900, -1), 60);
  EXPECT_NEAR(Painted().stroke(-900, 900), 1020, 60);  // across the canvas, and the tip's reach
}

TEST(StampBudget, AWayOfTooManyStampsIsRefused) {
  log::Limits limits;
  limits.max_move_stamps = 500;
  Painted painted(limits);
  EXPECT_NEAR(painted.stroke(0.2, 0.6), 400, 3);
  EXPECT_TRUE(painted.add(touch(log::TouchPhase::kDown, 0.2, 0.5)));
  const Result<void> over = painted.add(touch(log::TouchPhase::kMove, 0.8, 0.5));
  ASSERT_FALSE(over);
  EXPECT_EQ(over.error().code, ErrorCode::kLimit);
  EXPECT_NE(over.error().message.find("--limit move=N"), std::string::npos);
}

TEST(StampBudget, TooManyStampsOfTheLogAreRefused) {
  log::Limits limits;
  limits.max_stamps = 1000;
  Painted painted(limits);
  painted.stroke(0.2, 0.8);
  EXPECT_TRUE(painted.add(touch(log::TouchPhase::kDown, 0.2, 0.5)));
  const Result<void> over = painted.add(touch(log::TouchPhase::kUp, 0.8, 0.5));
  ASSERT_FALSE(over);
  EXPECT_NE(over.error().message.find("--limit stamps=N"), std::string::npos);
}

}  // namespace
}  // namespace pentimento

#include "replay/timeline/touches.h"

#include <gtest/gtest.h>

namespace pentimento {
namespace {

using log::TouchPhase;

/// Touches on a canvas of 1 x 1 m, at places of the log that count up.
struct Hand {
  Touches touches{{1, 1}};
  CueQueue queue;
  std::int64_t place = 0;

  log::Touch touch(TouchPhase phase, double x, std::int64_t id = 0) const {
    log::Touch t;
    t.phase = phase;
    t.id = id;
    t.x_m = x;
    t.y_m = 0.5;
    return t;
  }
  void add(double time_s, const log::Touch& t, std::uint32_t stroke_id = 1,
           const BrushSize& brush = {}) {
    ++place;
    const PlacedTouch at{t, {static_cast<std::int64_t>(time_s * 1e6), place}, place + 1};
    if (t.phase == TouchPhase::kDown) touches.down(at, brush, stroke_id, queue);
    if (t.phase == TouchPhase::kMove) touches.move(at, brush, queue);
    if (t.phase == TouchPhase::kUp) touches.up(at, brush, queue);
  }
  std::vector<Stamp> stamps() {
    std::vector<Stamp> out;
    while (!queue.empty()) {
      const PendingCue cue = queue.pop();
      if (const auto* stamp = std::get_if<StrokeStamp>(&cue.cue.what)) out.push_back(stamp->stamp);
    }
    return out;
  }
};

TEST(Touches, AnglesAreRadiansAndEachItsOwn) {
  Hand hand;
  log::Touch down = hand.touch(TouchPhase::kDown, 0.2), up = hand.touch(TouchPhase::kUp, 0.4);
  for (log::Touch* t : {&down, &up}) {
    t->tilt_x_deg = 30;
    t->tilt_y_deg = -45;
    t->twist_deg = 90;
    t->pressure = 0.5;
  }
  hand.add(0, down);
  hand.add(1, up);
  const std::vector<Stamp> stamps = hand.stamps();
  ASSERT_FALSE(stamps.empty());
  for (const Stamp& stamp : stamps) {
    EXPECT_FLOAT_EQ(stamp.tilt_x_rad, 0.5235988f);
    EXPECT_FLOAT_EQ(stamp.tilt_y_rad, -0.7853982f);
    EXPECT_FLOAT_EQ(stamp.twist_rad, 1.5707963f);
    EXPECT_FLOAT_EQ(stamp.pressure, 0.5f);
  }
}

TEST(Touches, ThePressureOfTheLastMoveStaysWhenAPenLifts) {
  Hand hand;
  log::Touch down = hand.touch(TouchPhase::kDown, 0.2), move = hand.touch(TouchPhase::kMove, 0.3),
             up = hand.touch(TouchPhase::kUp, 0.4);
  down.pressure = 0.2;
  move.pressure = 0.6;
  up.pressure = 0;
  hand.add(0, down);
  hand.add(0.5, move);
  hand.add(1, up);
  for (const Stamp& stamp : hand.stamps()) {
    if (stamp.x_m < 0.3) continue;
    EXPECT_FLOAT_EQ(stamp.pressure, 0.6f) << stamp.x_m;
  }
}

TEST(Touches, SizeAndSpacingThatChangeWithinAStrokeAreFollowed) {
  Hand hand;
  // The curve between two samples is known once the next has come, so the change takes effect
  // somewhere from 0.3 to 0.5 m.
  const BrushSize far = {0.02f, 0.5}, near = {0.02f, 0.1};
  hand.add(0, hand.touch(TouchPhase::kDown, 0.1), 1, far);
  for (int i = 2; i <= 4; ++i) hand.add(i, hand.touch(TouchPhase::kMove, 0.1 * i), 1, far);
  for (int i = 5; i <= 7; ++i) hand.add(i, hand.touch(TouchPhase::kMove, 0.1 * i), 1, near);
  hand.add(8, hand.touch(TouchPhase::kUp, 0.8), 1, near);
  int wide = 0, close = 0;
  for (const Stamp& stamp : hand.stamps()) {
    if (stamp.x_m > 0.11 && stamp.x_m < 0.29) ++wide;
    if (stamp.x_m > 0.51 && stamp.x_m < 0.69) ++close;
  }
  EXPECT_NEAR(wide, 18, 1);   // 0.18 m at 1 cm
  EXPECT_NEAR(close, 90, 1);  // at 2 mm
}

TEST(Touches, TheLowestFreeHandIsTaken) {
  Hand hand;
  hand.add(0.0, hand.touch(TouchPhase::kDown, 0.1, 11), 1);
  hand.add(0.1, hand.touch(TouchPhase::kDown, 0.2, 12), 2);
  hand.add(0.2, hand.touch(TouchPhase::kUp, 0.1, 11));
  hand.add(0.3, hand.touch(TouchPhase::kDown, 0.3, 13), 3);
  hand.add(0.4, hand.touch(TouchPhase::kDown, 0.4, 14), 4);
  std::vector<int> slots;
  std::vector<std::uint32_t> strokes;
  while (!hand.queue.empty()) {
    const PendingCue cue = hand.queue.pop();
    if (const auto* begin = std::get_if<StrokeBegin>(&cue.cue.what)) {
      slots.push_back(begin->slot);
      strokes.push_back(begin->stroke_id);
    }
  }
  EXPECT_EQ(slots, (std::vector<int>{0, 1, 0, 2}));
  EXPECT_EQ(strokes, (std::vector<std::uint32_t>{1, 2, 3, 4}));
}

TEST(Touches, AMoveOfATouchThatIsNotDownIsNothing) {
  Hand hand;
  hand.add(0, hand.touch(TouchPhase::kMove, 0.1, 5));
  hand.add(1, hand.touch(TouchPhase::kUp, 0.3, 5));
  EXPECT_TRUE(hand.queue.empty());
  EXPECT_FALSE(hand.touches.final_until());
}

TEST(Touches, TheSlowestOfThemSaysWhatIsSettled) {
  Hand hand;
  hand.add(0.0, hand.touch(TouchPhase::kDown, 0.1, 1), 1);
  hand.add(0.1, hand.touch(TouchPhase::kDown, 0.2, 2), 2);
  for (int i = 1; i < 10; ++i)
    hand.add(0.1 + 0.1 * i, hand.touch(TouchPhase::kMove, 0.2 + 0.05 * i, 2));
  const auto settled = hand.touches.final_until();
  ASSERT_TRUE(settled);
  EXPECT_EQ(settled->time_us, 0);  // the first touch has drawn nothing yet
}

}  // namespace
}  // namespace pentimento

#include "replay/timeline/timeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/replay/list_reader.h"

namespace pentimento {
namespace {

using log::TouchPhase;
using test::ListReader;

std::vector<Cue> play(ListReader& reader) {
  UndoTable undo;
  bool stepped = false;
  for (const log::Event& event : reader.events) {
    undo.add(event);
    stepped = stepped || std::holds_alternative<log::Step>(event.action);
  }
  const BrushTable brushes;
  Timeline timeline(reader, {undo, brushes, stepped, 1});
  std::vector<Cue> cues;
  while (true) {
    Result<std::optional<Cue>> cue = timeline.next();
    EXPECT_TRUE(cue.ok());
    if (!cue || !cue->has_value()) return cues;
    cues.push_back(**cue);
  }
}

std::vector<StrokeStamp> stamps_of(const std::vector<Cue>& cues, int hand = 0) {
  std::vector<StrokeStamp> stamps;
  for (const Cue& cue : cues) {
    const auto* stamp = std::get_if<StrokeStamp>(&cue.what);
    if (stamp != nullptr && stamp->slot == hand) stamps.push_back(*stamp);
  }
  return stamps;
}

TEST(Timeline, CuesComeInOrderOfTimeAndStep) {
  ListReader reader;
  reader.stroke(0.0, 1.0, 0.1, 0.6, 0.3);
  for (int i = 0; i < 50; ++i) reader.add(1.0 + 0.01 * i, log::Gravity{});
  const std::vector<Cue> cues = play(reader);
  ASSERT_GT(cues.size(), 60u);
  for (std::size_t i = 1; i < cues.size(); ++i) {
    EXPECT_LE(cues[i - 1].time_us, cues[i].time_us);
    EXPECT_LE(cues[i - 1].step, cues[i].step);
  }
}

TEST(Timeline, MostlyKnowsWhichCueComesNext) {
  ListReader reader;
  reader.stroke(0.0, 1.0, 0.1, 0.6, 0.3);
  UndoTable undo;
  for (const log::Event& event : reader.events) undo.add(event);
  const BrushTable brushes;
  Timeline timeline(reader, {undo, brushes, false, 1});
  EXPECT_EQ(timeline.peek(), nullptr);  // nothing has been read
  int cues = 0, known = 0;
  std::optional<Cue> expected;
  while (true) {
    const Result<std::optional<Cue>> cue = timeline.next();
    ASSERT_TRUE(cue.ok());
    if (!cue->has_value()) break;
    ++cues;
    if (expected && expected->time_us == (*cue)->time_us) ++known;
    expected = timeline.peek() == nullptr ? std::nullopt : std::optional(*timeline.peek());
  }
  EXPECT_FALSE(expected);  // nothing follows
  ASSERT_GT(cues, 60);
  EXPECT_GT(known, cues - 8);  // the five samples part the stroke
}

TEST(Timeline, StampsAreSpreadOverTheTimeBetweenSamples) {
  ListReader reader;  // one second, two samples only
  reader.stroke(0.0, 1.0, 0.1, 0.6, 0.3, 1);
  const std::vector<Cue> cues = play(reader);
  int steps_with_stamps = 0;
  std::int64_t last = -1;
  for (const Cue& cue : cues) {
    if (std::holds_alternative<StrokeStamp>(cue.what) && cue.step != last) {
      ++steps_with_stamps;
      last = cue.step;
    }
  }
  EXPECT_GE(steps_with_stamps, 44);  // of the 45 steps of that second
}

TEST(Timeline, WhatHappensDuringAStrokeComesBetweenItsStamps) {
  ListReader reader;
  reader.touch(0.0, TouchPhase::kDown, 0.1, 0.3);
  reader.add(0.5, log::Gravity{1, 2, 3});
  reader.touch(1.0, TouchPhase::kUp, 0.6, 0.3);
  const std::vector<Cue> cues = play(reader);
  std::size_t before = 0, after = 0;
  bool seen = false;
  for (const Cue& cue : cues) {
    if (std::holds_alternative<log::Action>(cue.what)) seen = true;
    if (std::holds_alternative<StrokeStamp>(cue.what)) ++(seen ? after : before);
  }
  EXPECT_GT(before, 100u);  // half of 0.5 m / (0.025 x 0.03 m) = 667 stamps, roughly
  EXPECT_GT(after, 100u);
}

TEST(Timeline, TheInputRateDoesNotMoveTheStamps) {
  // The same arc sampled at 30 and at 240 Hz. The spline through 30 Hz samples of this arc is
  // within 2e-5 m of it (sagitta of 1/30 s at 0.5 m/s on a radius of 0.2 m: 1.7e-4 m, cubic error a
  // tenth).
  const auto arc = [](int samples) {
    ListReader reader;
    for (int i = 0; i <= samples; ++i) {
      const double angle = 2.5 * i / samples;
      const auto phase = i == 0         ? TouchPhase::kDown
                         : i == samples ? TouchPhase::kUp
                                        : TouchPhase::kMove;
      reader.touch(static_cast<double>(i) / samples, phase, 0.5 + 0.2 * std::cos(angle),
                   0.4 + 0.2 * std::sin(angle));
    }
    return stamps_of(play(reader));
  };
  const std::vector<StrokeStamp> slow = arc(30);
  const std::vector<StrokeStamp> fast = arc(240);
  ASSERT_NEAR(static_cast<double>(slow.size()), static_cast<double>(fast.size()), 1.0);
  for (std::size_t i = 0; i < std::min(slow.size(), fast.size()) - 1; ++i) {
    EXPECT_NEAR(slow[i].stamp.x_m, fast[i].stamp.x_m, 2e-4);
    EXPECT_NEAR(slow[i].stamp.y_m, fast[i].stamp.y_m, 2e-4);
    EXPECT_NEAR(slow[i].stamp.time_s, fast[i].stamp.time_s, 2e-3);
  }
}

TEST(Timeline, SeveralTouchesAreSeveralStrokes) {
  ListReader reader;
  reader.touch(0.0, TouchPhase::kDown, 0.1, 0.1, 7);
  reader.touch(0.1, TouchPhase::kDown, 0.1, 0.5, 9);
  reader.touch(0.5, TouchPhase::kMove, 0.3, 0.1, 7);
  reader.touch(0.6, TouchPhase::kMove, 0.3, 0.5, 9);
  reader.touch(1.0, TouchPhase::kUp, 0.5, 0.1, 7);
  reader.touch(1.1, TouchPhase::kUp, 0.5, 0.5, 9);
  const std::vector<Cue> cues = play(reader);
  const auto first = stamps_of(cues, 0);
  const auto second = stamps_of(cues, 1);
  EXPECT_GT(first.size(), 400u);
  EXPECT_NEAR(static_cast<double>(first.size()), static_cast<double>(second.size()), 1.0);
  for (const StrokeStamp& s : first) EXPECT_DOUBLE_EQ(s.stamp.y_m, 0.1);
  for (const StrokeStamp& s : second) EXPECT_DOUBLE_EQ(s.stamp.y_m, 0.5);
}

TEST(Timeline, AHandIsFreeAgainOnceItsTouchLifts) {
  ListReader reader;  // browsers give every touch a new id
  reader.stroke(0.0, 0.5, 0.1, 0.2, 0.1, 2, 1001);
  reader.stroke(0.6, 0.9, 0.1, 0.2, 0.2, 2, 1002);
  std::vector<std::uint32_t> ids;
  for (const Cue& cue : play(reader)) {
    if (const auto* begin = std::get_if<StrokeBegin>(&cue.what)) {
      EXPECT_EQ(begin->slot, 0);
      ids.push_back(begin->stroke_id);
    }
  }
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{1, 2}));
}

TEST(Timeline, WhatIsUndoneLeavesNoCueAndNoStrokeId) {
  ListReader reader;
  reader.stroke(0.0, 0.2, 0.1, 0.2, 0.1);
  reader.stroke(0.3, 0.5, 0.1, 0.2, 0.2);
  reader.add(0.55, log::Dry{});
  reader.add(0.6, log::Undo{});
  reader.add(0.6, log::Undo{});
  reader.stroke(0.7, 0.9, 0.1, 0.2, 0.3);
  std::vector<std::uint32_t> ids;
  for (const Cue& cue : play(reader)) {
    EXPECT_FALSE(std::holds_alternative<log::Action>(cue.what));
    if (const auto* begin = std::get_if<StrokeBegin>(&cue.what)) ids.push_back(begin->stroke_id);
    if (const auto* stamp = std::get_if<StrokeStamp>(&cue.what)) {
      EXPECT_NE(stamp->stamp.y_m, 0.2);
    }
  }
  EXPECT_EQ(ids, (std::vector<std::uint32_t>{1, 2}));
}

TEST(Timeline, ALogWithStepsIsSteppedByThemAlone) {
  ListReader reader;  // all times are zero: only the order counts
  reader.add(0, log::Gravity{});
  reader.add(0, log::Step{});
  reader.add(0, log::Step{});
  reader.touch(0, TouchPhase::kDown, 0.1, 0.1);
  reader.add(0, log::Step{});
  reader.touch(0, TouchPhase::kMove, 0.2, 0.1);
  reader.add(0, log::Step{});
  reader.touch(0, TouchPhase::kUp, 0.3, 0.1);
  reader.add(0, log::Dry{});
  const std::vector<Cue> cues = play(reader);
  EXPECT_EQ(cues.front().step, 0);
  EXPECT_EQ(cues.back().step, 4);
  for (const Cue& cue : cues) {
    if (std::holds_alternative<StrokeBegin>(cue.what)) {
      EXPECT_EQ(cue.step, 2);
    }
    const auto* stamp = std::get_if<StrokeStamp>(&cue.what);
    if (stamp == nullptr) continue;
    EXPECT_EQ(cue.step, stamp->stamp.x_m < 0.2 + 1e-9 ? 3 : 4) << stamp->stamp.x_m;
  }
}

TEST(Timeline, AStrokeThatIsDownAtTheEndIsLiftedThere) {
  ListReader reader;
  reader.touch(0.0, TouchPhase::kDown, 0.1, 0.1);
  reader.touch(0.5, TouchPhase::kMove, 0.3, 0.1);
  const std::vector<Cue> cues = play(reader);
  EXPECT_GT(stamps_of(cues).size(), 200u);
  EXPECT_TRUE(std::holds_alternative<StrokeEnd>(cues.back().what));
}

TEST(Timeline, ALongRestDoesNotHoldEverythingBack) {
  // A finger that lies still while far more happens than is kept waiting: memory stays bounded, and
  // nothing is lost or goes back in time.
  ListReader reader;
  reader.touch(0.0, TouchPhase::kDown, 0.1, 0.1);
  const int rest = static_cast<int>(Timeline::kMaxPending) + 500;
  for (int i = 0; i < rest; ++i) reader.add(0.001 * i, log::Gravity{});
  reader.touch(0.001 * rest, TouchPhase::kUp, 0.3, 0.1);
  const std::vector<Cue> cues = play(reader);
  std::int64_t step = 0;
  int gravities = 0;
  for (const Cue& cue : cues) {
    EXPECT_GE(cue.step, step);
    step = cue.step;
    gravities += std::holds_alternative<log::Action>(cue.what) ? 1 : 0;
  }
  EXPECT_EQ(gravities, rest);
  EXPECT_GT(stamps_of(cues).size(), 200u);
}

TEST(Timeline, SizeAndSpacingFollowTheSliders) {
  ListReader reader;
  reader.add(0, log::Slider{"size", 0.1});
  reader.add(0, log::Slider{"spacing", 0.1});
  reader.stroke(0.0, 1.0, 0.1, 0.6, 0.3);
  const auto stamps = stamps_of(play(reader));
  EXPECT_NEAR(static_cast<double>(stamps.size()), 0.5 / (0.1 * 0.1), 2.0);
  EXPECT_FLOAT_EQ(stamps.front().stamp.diameter_m, 0.1f);
}

TEST(Timeline, LiftingKeepsThePressure) {
  ListReader reader;  // devices report pressure 0 when the pen lifts
  log::Touch down;
  down.phase = TouchPhase::kDown;
  down.x_m = down.y_m = 0.2;
  down.pressure = 0.6;
  log::Touch up = down;
  up.phase = TouchPhase::kUp;
  up.pressure = 0;
  reader.add(0, down);
  reader.add(0.1, up);
  const auto stamps = stamps_of(play(reader));
  ASSERT_FALSE(stamps.empty());
  for (const StrokeStamp& s : stamps) EXPECT_FLOAT_EQ(s.stamp.pressure, 0.6f);
}

}  // namespace
}  // namespace pentimento
